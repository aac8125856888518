// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QObject>
#include <memory>

#include "widgets/session/background_queue.h"
#include "widgets/session/demo_scenes.h"
#include "widgets/start/picture_cache.h"

class QOffscreenSurface;

namespace sline::widgets {

/// Provides pictures of the demo scenes, drawn once by the renderer itself, in the background and
/// when nothing else is to be done.
class DemoPictures : public QObject {
  Q_OBJECT
 public:
  explicit DemoPictures(PictureCache cache, QObject* parent = nullptr);
  ~DemoPictures() override;

  enum class Missing { draw, leave };
  /// Asks for the pictures of the demos, remembered ones first. Each is answered by `drawn`, unless
  /// it is missing and is to be left so, or cannot be drawn.
  void ask(const std::vector<DemoScene>& demos, Missing missing);
  /// Stops the drawing that is under way.
  void stop();

 signals:
  void drawn(const QString& id, const QImage& picture);

 private:
  void findOrDraw(const DemoScene& demo);
  void draw(const DemoScene& demo);

  PictureCache m_cache;
  std::unique_ptr<QOffscreenSurface> m_surface;
  Missing m_missing = Missing::leave;
  BackgroundQueue m_queue;
};

}  // namespace sline::widgets
