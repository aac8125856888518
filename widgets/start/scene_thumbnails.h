// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QObject>

#include "widgets/session/background_queue.h"
#include "widgets/start/picture_cache.h"

namespace sline::widgets {

/// Provides the small pictures in scene files, which are read in the background and remembered.
class SceneThumbnails : public QObject {
  Q_OBJECT
 public:
  explicit SceneThumbnails(PictureCache cache, QObject* parent = nullptr);
  /// Asks for the picture of the file; one of the signals answers.
  void ask(const QString& file);
  /// Drops the pending requests.
  void drop() { m_queue.drop(); }

 signals:
  /// Tells the picture; null if the file exists but has none.
  void found(const QString& file, const QImage& picture);
  void missing(const QString& file);

 private:
  PictureCache m_cache;
  BackgroundQueue m_queue;
};

}  // namespace sline::widgets
