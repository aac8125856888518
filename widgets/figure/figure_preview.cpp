// SPDX-License-Identifier: Apache-2.0
#include "widgets/figure/figure_preview.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace sline::widgets {

namespace {

constexpr int margin = 8;  // around the page, pixels

}  // namespace

FigurePreview::FigurePreview(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("figurePreview"));
  setAccessibleName(tr("The figure"));
  setToolTip(tr("Drag a rectangle in a panel to show that part enlarged"));
  setMinimumSize(240, 200);
  setCursor(Qt::CrossCursor);
}

void FigurePreview::show(const QImage& page, const model::FigureLayout& layout) {
  m_page = page;
  m_layout = layout;
  m_pressed.reset();
  if (m_chosen && *m_chosen >= layout.panels.size())
    m_chosen.reset();
  update();
}

void FigurePreview::setStale(const QString& why) {
  if (why == m_stale)
    return;
  m_stale = why;
  update();
}

void FigurePreview::choose(std::optional<std::size_t> panel) {
  m_chosen = panel;
  update();
}

int FigurePreview::pageWidth(const QSizeF& room, const glm::vec2& pageMm) {
  const double shape = double(pageMm.x / pageMm.y);
  return std::max(64, int(std::lround(std::min(room.width(), room.height() * shape))));
}

QRectF FigurePreview::pageRect() const {
  if (m_page.isNull())
    return {};
  const qreal above = margin + fontMetrics().height();  // what is said of the page stands there
  const QRectF room = QRectF(rect()).marginsRemoved({margin, above, margin, margin});
  QSizeF page = QSizeF(m_page.size()).scaled(room.size(), Qt::KeepAspectRatio);
  QRectF placed({}, page);
  placed.moveCenter(room.center());
  return placed;
}

QPointF FigurePreview::onScreen(const glm::vec2& mm) const {
  const QRectF page = pageRect();
  const qreal scale = page.width() / qreal(std::max(m_layout.sizeMm.x, 1.0f));
  return page.topLeft() + scale * QPointF(qreal(mm.x), qreal(mm.y));
}

glm::vec2 FigurePreview::onPage(const QPointF& place) const {
  const QRectF page = pageRect();
  const QPointF on = (place - page.topLeft()) / std::max(page.width(), 1.0);
  return float(m_layout.sizeMm.x) * glm::vec2(float(on.x()), float(on.y()));
}

std::optional<std::size_t> FigurePreview::panelAt(const glm::vec2& place) const {
  std::optional<std::size_t> topmost;
  for (const std::size_t i : m_layout.order) {
    const model::FigureBox& box = m_layout.panels[i].box;
    if (place.x >= box.at.x && place.y >= box.at.y && place.x <= box.end().x &&
        place.y <= box.end().y)
      topmost = i;
  }
  return topmost;
}

model::FigureBox FigurePreview::dragged() const {
  const model::FigureBox& box = m_layout.panels[*m_pressed].box;
  const glm::vec2 from = glm::clamp(m_from, box.at, box.end());
  const glm::vec2 to = glm::clamp(m_to, box.at, box.end());
  return {glm::min(from, to), glm::abs(to - from)};
}

void FigurePreview::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().color(QPalette::Mid));
  if (m_page.isNull()) {
    painter.drawText(rect(), Qt::AlignCenter, tr("Drawing…"));
    return;
  }
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(pageRect(), m_page);
  if (!m_stale.isEmpty()) {
    constexpr int veil = 150;  // of 255
    QColor over = palette().color(QPalette::Mid);
    over.setAlpha(veil);
    painter.fillRect(pageRect(), over);
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(rect().adjusted(margin, margin, -margin, -margin),
                     Qt::AlignTop | Qt::AlignHCenter | Qt::TextWordWrap, m_stale);
  }
  const auto outline = [&](const model::FigureBox& box, Qt::PenStyle style) {
    painter.setPen(QPen(palette().color(QPalette::Highlight), 1.5, style));
    painter.drawRect(QRectF(onScreen(box.at), onScreen(box.end())));
  };
  if (m_chosen && *m_chosen < m_layout.panels.size())
    outline(m_layout.panels[*m_chosen].box, Qt::SolidLine);
  if (m_pressed && m_from != m_to)
    outline(dragged(), Qt::DashLine);
}

void FigurePreview::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  emit resized();
}

void FigurePreview::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || m_page.isNull())
    return;
  m_from = m_to = onPage(event->position());
  m_pressed = panelAt(m_from);
  if (m_pressed)
    emit chosen(*m_pressed);
}

void FigurePreview::mouseMoveEvent(QMouseEvent* event) {
  if (!m_pressed)
    return;
  m_to = onPage(event->position());
  update();
}

void FigurePreview::mouseReleaseEvent(QMouseEvent*) {
  if (!m_pressed)
    return;
  constexpr float leastDragMm = 3.0f;  // less is a press that shook
  model::FigureBox part = dragged();
  const std::size_t panel = *m_pressed;
  m_pressed.reset();
  update();
  part.at -= m_layout.panels[panel].box.at;
  if (std::min(part.size.x, part.size.y) >= leastDragMm)
    emit framed(panel, part);
}

}  // namespace sline::widgets

#include "moc_figure_preview.cpp"
