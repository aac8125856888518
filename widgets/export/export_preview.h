// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QPointer>
#include <QTimer>
#include <QWidget>
#include <optional>

#include "widgets/export/export_files.h"
#include "widgets/session/background_queue.h"
#include "widgets/viewport/viewport.h"

namespace sline::widgets {

/// The page as it will be, as large as there is room: drawn by the window's renderer when it has
/// nothing else to do, with labels painted as the files have them.
class ExportPreview : public QWidget {
  Q_OBJECT
 public:
  explicit ExportPreview(Viewport& viewport, QWidget* parent = nullptr);
  /// Nobody draws for it any more.
  ~ExportPreview() override;

  /// Soon; what comes before it is drawn replaces it.
  void show(const ExportFile& file);
  /// True where it shows what was asked for last.
  bool upToDate() const { return m_shown == m_wanted; }
  const QImage& picture() const { return m_picture; }
  /// Of the page that it shows.
  const render::ExportNotes& notes() const { return m_notes; }
  QSize sizeHint() const override { return {400, 400}; }

 signals:
  /// It shows what was asked for.
  void drawn();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  QRect pageRect() const;
  void ask();
  void draw(int number, const render::ExportOrder& order);
  void took(PreviewsOf asker, int number, const QImage& image);

  QPointer<Viewport> m_viewport;  ///< a window that closes may take it away first
  QTimer m_rest;
  std::optional<ExportFile> m_file;
  render::ExportOrder m_drawn;  ///< what the renderer was asked for
  int m_wanted = 0;             ///< counts what was asked for
  int m_shown = 0;
  QImage m_picture;
  render::ExportNotes m_notes;
  BackgroundQueue m_queue;
};

}  // namespace sline::widgets
