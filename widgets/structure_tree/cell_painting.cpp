// SPDX-License-Identifier: Apache-2.0
#include "widgets/structure_tree/cell_painting.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "widgets/gamma/stages.h"

namespace sline::widgets {

namespace {

constexpr double numberWidth = 34.0;
constexpr double handleRadius = 5.0;

QColor faded(QColor colour, double opacity) {
  colour.setAlphaF(float(opacity));
  return colour;
}

QPainterPath eyeOutline(const QPointF& centre, double size) {
  QPainterPath path(centre + QPointF(-size, 0.0));
  path.quadTo(centre + QPointF(0.0, -1.25 * size), centre + QPointF(size, 0.0));
  path.quadTo(centre + QPointF(0.0, 1.25 * size), centre + QPointF(-size, 0.0));
  return path;
}

}  // namespace

QRectF GammaCell::groove() const {
  const double left = cell.left() + handleRadius + 4.0;
  const double right = cell.right() - numberWidth - handleRadius - 6.0;
  return {left, cell.center().y() - 1.5, std::max(right - left, 1.0), 3.0};
}

QRectF GammaCell::number() const {
  return {cell.right() - numberWidth - 4.0, cell.top(), numberWidth, cell.height()};
}

double GammaCell::xOf(Gamma gamma) const {
  return groove().left() + groove().width() * double(gamma.value()) / 5.0;
}

Gamma GammaCell::gammaAt(double x) const {
  // Γ is rounded to 0.05, because a finer step would be less than a pixel of so short a groove.
  const double gamma = 5.0 * (x - groove().left()) / groove().width();
  return Gamma::clamped(float(std::round(gamma * 20.0) / 20.0));
}

void paintEye(QPainter& painter, const QRectF& cell, model::Visibility shown,
              const QPalette& palette) {
  const QColor ink = palette.color(QPalette::Text);
  const QPointF centre = cell.center() + QPointF(0.5, 0.5);
  constexpr double size = 7.0;
  const bool hidden = shown == model::Visibility::none;
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(faded(ink, hidden ? 0.3 : 0.75), 1.2));
  painter.drawPath(eyeOutline(centre, size));
  if (hidden) {
    painter.drawLine(centre + QPointF(-6.0, 5.0), centre + QPointF(6.0, -5.0));
    return;
  }
  if (shown == model::Visibility::all) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(faded(ink, 0.75));
  }
  painter.drawEllipse(centre, 2.4, 2.4);
}

void paintSwatch(QPainter& painter, const QRectF& cell, const SwatchState& state,
                 const QPalette& palette) {
  const double side = state.own ? 13.0 : 9.0;
  QRectF square(0.0, 0.0, side, side);
  square.moveCenter(QRectF(cell.toAlignedRect()).center());
  QPainterPath outline;
  outline.addRoundedRect(square, state.own ? 3.0 : 2.0, state.own ? 3.0 : 2.0);
  const auto count = double(std::max<std::size_t>(state.colours.size(), 1));
  const double width = square.width() / count;
  QRectF lower = square;
  lower.setTop(square.center().y());
  QPainterPath faint;
  if (state.opacity < 1.0f)
    faint.addRect(lower);
  for (std::size_t i = 0; i < state.colours.size(); ++i) {
    QPainterPath part;
    part.addRect(square.left() + width * double(i), square.top(), width, square.height());
    part = outline.intersected(part);
    painter.fillPath(part.subtracted(faint), state.colours[i]);
    painter.fillPath(part.intersected(faint), faded(state.colours[i], double(state.opacity)));
  }
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(faded(palette.color(QPalette::Text), state.own ? 0.45 : 0.2), 1.0));
  painter.drawPath(outline);
}

void paintLock(QPainter& painter, const QRectF& cell, RowLock lock, bool underMouse,
               const QPalette& palette) {
  if (lock == RowLock::open && !underMouse)
    return;
  const bool open = lock == RowLock::open;
  const QColor ink = faded(palette.color(QPalette::Text), open                   ? 0.35
                                                          : lock == RowLock::own ? 0.85
                                                                                 : 0.4);
  const QPointF centre = QRectF(cell.toAlignedRect()).center();
  const QRectF body(centre.x() - 4.5, centre.y() - 0.5, 9.0, 6.5);
  QPainterPath shackle;
  const double right = open ? 6.0 : 0.0;  // swung aside
  shackle.moveTo(centre.x() - 2.8 + right, body.top());
  shackle.lineTo(centre.x() - 2.8 + right, centre.y() - 2.5);
  shackle.arcTo(QRectF(centre.x() - 2.8 + right, centre.y() - 5.8, 5.6, 6.2), 180.0, -180.0);
  if (!open)
    shackle.lineTo(centre.x() + 2.8, body.top());
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(ink, 1.4, Qt::SolidLine, Qt::FlatCap));
  painter.drawPath(shackle);
  if (open) {
    painter.drawRoundedRect(body.adjusted(0.5, 0.5, -0.5, -0.5), 1.2, 1.2);
    return;
  }
  painter.setPen(Qt::NoPen);
  painter.setBrush(ink);
  painter.drawRoundedRect(body, 1.5, 1.5);
}

void paintDropMark(QPainter& painter, const QRectF& mark, bool into, const QPalette& palette) {
  const QColor accent = palette.color(QPalette::Highlight);
  painter.setPen(QPen(accent, 2.0));
  painter.setBrush(Qt::NoBrush);
  if (into) {
    painter.drawRoundedRect(mark.adjusted(2.0, 1.0, -2.0, -1.0), 4.0, 4.0);
    return;
  }
  const double y = std::max(mark.center().y(), 3.5);
  constexpr double ring = 3.0;
  painter.drawEllipse(QPointF(mark.left() + ring + 1.0, y), ring, ring);
  painter.drawLine(QPointF(mark.left() + 2.0 * ring + 1.0, y), QPointF(mark.right() - 2.0, y));
}

void paintGamma(QPainter& painter, const GammaCell& cell, const GammaState& state,
                const QPalette& palette) {
  const QColor text = palette.color(state.selected ? QPalette::HighlightedText : QPalette::Text);
  const QColor accent = state.selected ? palette.color(QPalette::HighlightedText)
                                       : palette.color(QPalette::Highlight);
  const bool one = state.range.low == state.range.high;
  const QRectF groove = cell.groove();
  painter.setPen(Qt::NoPen);
  painter.setBrush(faded(text, 0.22));
  painter.drawRoundedRect(groove, 1.5, 1.5);
  for (int stage = 1; stage < 5; ++stage)
    painter.drawRect(QRectF(cell.xOf(Gamma::clamped(float(stage))) - 0.5, groove.top() - 3.0, 1.0,
                            groove.height() + 6.0));
  // A thin grey bar shows a value from above, a full one the node's own; several that differ show
  // their range.
  const double from = one ? groove.left() : cell.xOf(state.range.low);
  const double to = cell.xOf(state.range.high);
  painter.setBrush(state.own ? accent : faded(accent, 0.4));
  painter.drawRoundedRect(QRectF(from, groove.top(), std::max(to - from, 0.0), groove.height()),
                          1.5, 1.5);
  if (one && !state.locked) {
    const QPointF at(to, groove.center().y());
    painter.setPen(QPen(state.own ? accent : faded(text, 0.5), 1.4));
    painter.setBrush(
        state.own ? accent : palette.color(state.selected ? QPalette::Highlight : QPalette::Base));
    painter.drawEllipse(at, handleRadius - 0.7, handleRadius - 0.7);
  }
  painter.setPen(faded(text, state.own ? 1.0 : 0.55));
  painter.drawText(cell.number(), Qt::AlignRight | Qt::AlignVCenter,
                   one ? gammaText(state.range.low) : QStringLiteral("…"));
}

}  // namespace sline::widgets
