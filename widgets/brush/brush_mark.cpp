// SPDX-License-Identifier: Apache-2.0
#include "widgets/brush/brush_mark.h"

#include <QPainter>

#include "widgets/viewport/tools/points.h"

namespace sline::widgets {

namespace {

constexpr double thin = 1.4;       ///< pixels
constexpr double haloWidth = 2.2;  ///< pixels around the line

}  // namespace

BrushMark::BrushMark(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("brushMark"));
  setAttribute(Qt::WA_TransparentForMouseEvents);
  hide();
}

void BrushMark::show(const State& state) {
  if (state == m_state)
    return;
  m_state = state;
  setVisible(m_state.at.has_value());
  update();
}

void BrushMark::setDark(bool dark) {
  m_dark = dark;
  update();
}

void BrushMark::paintEvent(QPaintEvent*) {
  if (!m_state.at)
    return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  const QPointF middle = point(*m_state.at);
  QColor line = m_dark ? QColor(126, 190, 255) : QColor(18, 92, 156);
  if (m_state.brush.erases)
    line = m_dark ? QColor(255, 190, 92) : QColor(178, 84, 0);
  line.setAlpha(m_state.onTarget ? 255 : 110);
  const auto ring = [&](double radius, Qt::PenStyle style) {
    painter.setPen(
        QPen(m_dark ? QColor(16, 17, 19, 170) : QColor(255, 255, 255, 190), thin + haloWidth));
    painter.drawEllipse(middle, radius, radius);
    painter.setPen(QPen(line, thin, style));
    painter.drawEllipse(middle, radius, radius);
  };
  ring(double(m_state.brush.radius), Qt::SolidLine);
  const double core = double((1.0f - m_state.brush.softness) * m_state.brush.radius);
  constexpr double least = 3.0;
  if (m_state.brush.softness > 0.0f && core > least)
    ring(core, Qt::DotLine);
  if (m_state.brush.erases) {
    painter.setPen(QPen(line, thin));
    painter.drawLine(middle - QPointF(4.0, 0.0), middle + QPointF(4.0, 0.0));
  }
}

}  // namespace sline::widgets

#include "moc_brush_mark.cpp"
