// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

#include "widgets/export/export_files.h"
#include "widgets/session/background_queue.h"
#include "widgets/viewport/viewport.h"

namespace sline::widgets {

/// Copies the window's picture to the clipboard, twice as fine as on screen, with labels and marks
/// as exports have them.
class PictureCopier : public QObject {
  Q_OBJECT
 public:
  explicit PictureCopier(Viewport& viewport, QObject* parent = nullptr);

  /// Copies the picture soon; `order` gives the look of labels and marks.
  void copy(const ExportSource& source, const render::ExportOrder& order);

 signals:
  void copied();

 private:
  void took(PreviewsOf asker, int number, const QImage& image);

  Viewport& m_viewport;
  render::ExportOrder m_order;
  int m_wanted = 0;  ///< counts down; the dialog's preview, drawn by the same renderer, counts up
  BackgroundQueue m_queue;
};

}  // namespace sline::widgets
