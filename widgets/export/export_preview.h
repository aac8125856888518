// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QPointer>
#include <QTimer>
#include <QWidget>
#include <algorithm>
#include <optional>
#include <vector>

#include "widgets/export/export_files.h"
#include "widgets/session/background_queue.h"
#include "widgets/viewport/viewport.h"

namespace sline::widgets {

/// Shows the page as it will be, as large as there is room: drawn by the window's renderer when it
/// has nothing else to do, with labels painted as the files have them.
class ExportPreview : public QWidget {
  Q_OBJECT
 public:
  explicit ExportPreview(Viewport& viewport, QWidget* parent = nullptr);
  /// Cancels what the renderer still has to draw for it.
  ~ExportPreview() override;

  /// Shows the file soon; a later call before it is drawn replaces it.
  void show(const render::ExportPiece& file);
  /// Tells whether the preview shows what was asked for last.
  bool upToDate() const { return m_shown == m_wanted; }
  /// Returns the page that is shown; a null image before the first is there.
  QImage picture() const { return m_pages.empty() ? QImage() : m_pages[page()]; }
  /// Returns how many pages the file has; 1 before they are known.
  std::size_t pages() const { return std::max<std::size_t>(m_pages.size(), 1); }
  /// Shows that page, or the last one where there are fewer.
  void turnTo(std::size_t page);
  /// Returns the notes on the page that is shown.
  const render::ExportNotes& notes() const { return m_notes; }
  QSize sizeHint() const override { return {400, 400}; }

 signals:
  /// Tells that the preview shows what was asked for.
  void drawn();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  std::size_t page() const { return std::min(m_page, m_pages.size() - 1); }
  QRect pageRect() const;
  /// Returns the pixels of the page on screen.
  QSize pixels() const;
  void ask();
  void draw(int number, const render::ExportOrder& order);
  void took(PreviewsOf asker, int number, const QImage& image);

  QPointer<Viewport> m_viewport;  ///< a window that closes may take it away first
  QTimer m_rest;
  std::optional<render::ExportPiece> m_file;
  render::ExportOrder m_drawn;  ///< the order that the renderer was given
  int m_wanted = 0;             ///< counts the requests
  int m_shown = 0;
  std::vector<QImage> m_pages;
  std::size_t m_page = 0;
  render::ExportNotes m_notes;
  BackgroundQueue m_queue;
};

}  // namespace sline::widgets
