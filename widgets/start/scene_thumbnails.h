// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QObject>

#include "widgets/session/background_queue.h"
#include "widgets/start/picture_cache.h"

namespace sline::widgets {

/// The small pictures in scene files, read in the background and remembered.
class SceneThumbnails : public QObject {
  Q_OBJECT
 public:
  explicit SceneThumbnails(PictureCache cache, QObject* parent = nullptr);
  /// Answered by one of the signals.
  void ask(const QString& file);
  /// Forgets what was asked for.
  void drop() { m_queue.drop(); }

 signals:
  /// Null: the file is there, but has none.
  void found(const QString& file, const QImage& picture);
  void missing(const QString& file);

 private:
  PictureCache m_cache;
  BackgroundQueue m_queue;
};

}  // namespace sline::widgets
