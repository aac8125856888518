// SPDX-License-Identifier: Apache-2.0
#include "widgets/gamma/style_slider.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

namespace sline::widgets {

namespace {
constexpr int positions = 1000;
constexpr double handleMargin = 11.0;  // half a handle
}  // namespace

StyleSlider::StyleSlider(double high, double step, double power, QWidget* parent)
    : DragSlider(Qt::Horizontal, parent), m_high(high), m_step(step), m_power(power) {
  setRange(0, positions);
  setPageStep(positions / 10);
  setSingleStep(positions / 100);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

double StyleSlider::valueOf(int position) const {
  const double value = m_high * std::pow(double(position) / positions, m_power);
  return std::clamp(m_step * std::round(value / m_step), 0.0, m_high);
}

int StyleSlider::positionOf(double value) const {
  const double share = std::clamp(value / m_high, 0.0, 1.0);
  return int(std::lround(positions * std::pow(share, 1.0 / m_power)));
}

QPointF StyleSlider::pointOf(double value) const {
  return {handleMargin + (width() - 2.0 * handleMargin) * positionOf(value) / positions,
          0.5 * height()};
}

int StyleSlider::positionAt(const QPointF& point) const {
  const double share = (point.x() - handleMargin) / std::max(1.0, width() - 2.0 * handleMargin);
  return int(std::lround(positions * std::clamp(share, 0.0, 1.0)));
}

void StyleSlider::showRange(double low, double high, bool own) {
  m_low = low;
  m_up = high;
  m_own = own;
  show(positionOf(0.5 * (low + high)));
  update();
}

int StyleSlider::positionAfter(int steps) const {
  // Steps count from the number, wherever the slider stands.
  return positionOf(std::clamp(middle() + steps * m_step, 0.0, m_high));
}

void StyleSlider::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(palette().color(QPalette::Mid), 4.0, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(pointOf(0.0), pointOf(m_high));
  if (!isEnabled())
    return;
  painter.setPen(QPen(palette().color(QPalette::Highlight), 4.0, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(m_low == m_up ? pointOf(0.0) : pointOf(m_low), pointOf(m_up));
  paintHandle(painter, pointOf(middle()), m_own && m_low == m_up);
}

}  // namespace sline::widgets

#include "moc_style_slider.cpp"
