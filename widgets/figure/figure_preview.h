// SPDX-License-Identifier: Apache-2.0
// Shows a figure's page; a press chooses a panel, a drag in one frames what an inset shows.
#pragma once

#include <QImage>
#include <QWidget>
#include <optional>

#include "model/figure/figure_layout.h"

namespace sline::widgets {

class FigurePreview : public QWidget {
  Q_OBJECT
 public:
  explicit FigurePreview(QWidget* parent = nullptr);

  /// Shows that picture of a page laid out like that.
  void show(const QImage& page, const model::FigureLayout& layout);
  /// Says in words why the page shown is not the figure as it is; empty: it is.
  void setStale(const QString& why);
  const QString& stale() const { return m_stale; }
  /// Marks the panel; absent: none.
  void choose(std::optional<std::size_t> panel);
  const QImage& picture() const { return m_page; }
  /// Returns how wide a page is drawn in a room, in the room's pixels.
  static int pageWidth(const QSizeF& room, const glm::vec2& pageMm);
  /// Returns where a place of the page is in the widget.
  QPointF onScreen(const glm::vec2& mm) const;
  QSize sizeHint() const override { return {620, 520}; }

 signals:
  void chosen(std::size_t panel);
  /// Tells that a part of a panel was framed, in millimetres from the panel's corner.
  void framed(std::size_t panel, const sline::model::FigureBox& part);
  /// Tells that the page can be shown larger or smaller.
  void resized();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  QRectF pageRect() const;
  glm::vec2 onPage(const QPointF& place) const;
  /// Returns the topmost panel there.
  std::optional<std::size_t> panelAt(const glm::vec2& place) const;
  /// Returns the rectangle that is being dragged, within its panel, on the page.
  model::FigureBox dragged() const;

  QString m_stale;
  QImage m_page;
  model::FigureLayout m_layout;
  std::optional<std::size_t> m_chosen;
  std::optional<std::size_t> m_pressed;  ///< the panel in which a drag began
  glm::vec2 m_from{0.0f};                ///< on the page
  glm::vec2 m_to{0.0f};
};

}  // namespace sline::widgets
