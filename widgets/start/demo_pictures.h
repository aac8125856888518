// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QObject>
#include <memory>

#include "widgets/session/background_queue.h"
#include "widgets/session/demo_scenes.h"
#include "widgets/start/picture_cache.h"

namespace sline::widgets {

/// Returns the folder of the pictures that were drawn of the demos when the program was built:
/// ../share/sline/demos, from where the program lies.
std::filesystem::path builtDemoPictures();

/// Provides pictures of the demo scenes: those drawn when the program was built, at once; where one
/// is missing or shows an older demo, the renderer draws it, once, in the background and when
/// nothing else is to be done.
class DemoPictures : public QObject {
  Q_OBJECT
 public:
  /// Reads pictures from both, and keeps in the second what it draws.
  DemoPictures(PictureCache built, PictureCache cache, QObject* parent = nullptr);
  ~DemoPictures() override;

  enum class Missing { draw, leave };
  /// Asks for the pictures of the demos. Each is answered by `drawn`, before this returns if it was
  /// drawn when the program was built, else later, unless it is missing and is to be left so, or
  /// cannot be drawn.
  void ask(const std::vector<DemoScene>& demos, Missing missing);
  /// Stops the drawing that is under way.
  void stop();

 signals:
  void drawn(const QString& id, const QImage& picture);

 private:
  void findOrDraw(const DemoScene& demo);
  void draw(const DemoScene& demo);

  PictureCache m_built;
  PictureCache m_cache;
  Missing m_missing = Missing::leave;
  BackgroundQueue m_queue;
};

}  // namespace sline::widgets
