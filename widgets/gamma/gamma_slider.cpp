// SPDX-License-Identifier: Apache-2.0
#include "widgets/gamma/gamma_slider.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "widgets/gamma/stages.h"

namespace sline::widgets {

namespace {

constexpr int unitsPerGamma = 100;
constexpr double grooveMargin = 33.0;  // above and below the groove: half a stage's picture
constexpr double grooveX = 16.0;
constexpr int wide = 40;

int toUnits(Gamma gamma) {
  return int(std::lround(gamma.value() * unitsPerGamma));
}

}  // namespace

GammaSlider::GammaSlider(QWidget* parent) : DragSlider(Qt::Vertical, parent) {
  setRange(0, 5 * unitsPerGamma);
  setSingleStep(unitsPerGamma / 20);
  setPageStep(unitsPerGamma);
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Expanding);
}

void GammaSlider::showGamma(const model::GammaRange& range, bool own) {
  m_range = range;
  m_own = own;
  show(toUnits(middle()));
  update();
}

Gamma GammaSlider::middle() const {
  return Gamma::clamped(0.5f * (m_range.low.value() + m_range.high.value()));
}

QSize GammaSlider::sizeHint() const {
  return {wide, 276};
}

QSize GammaSlider::minimumSizeHint() const {
  return {wide, 244};
}

QPointF GammaSlider::pointOf(Gamma gamma) const {
  const double length = height() - 2.0 * grooveMargin;
  return {grooveX, grooveMargin + length * (1.0 - double(gamma.value()) / 5.0)};
}

Gamma GammaSlider::gammaOf(int position) {
  return Gamma::clamped(float(position) / unitsPerGamma);
}

int GammaSlider::positionAt(const QPointF& point) const {
  const double length = std::max(1.0, height() - 2.0 * grooveMargin);
  const double share = 1.0 - (point.y() - grooveMargin) / length;
  return std::clamp(int(std::lround(share * maximum())), minimum(), maximum());
}

void GammaSlider::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  paintGroove(painter);
  if (isEnabled())
    paintHandle(painter, pointOf(gammaOf(value())), m_own && m_range.low == m_range.high);
}

void GammaSlider::paintGroove(QPainter& painter) const {
  const QPointF top = pointOf(Gamma::clamped(5.0f));
  const QPointF bottom = pointOf(Gamma::clamped(0.0f));
  painter.setPen(QPen(palette().color(QPalette::Mid), 4.0, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(top, bottom);
  QColor tick = palette().color(QPalette::WindowText);
  tick.setAlpha(90);
  painter.setPen(QPen(tick, 1.0));
  for (const Stage& stage : gammaStages()) {
    const QPointF at = pointOf(Gamma::clamped(stage.gamma));
    painter.drawLine(at + QPointF(14.0, 0.0), at + QPointF(wide - grooveX - 4.0, 0.0));
  }
  if (!isEnabled())
    return;
  painter.setPen(QPen(palette().color(QPalette::Highlight), 4.0, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(m_range.low == m_range.high ? bottom : pointOf(m_range.low),
                   pointOf(m_range.high));
}

}  // namespace sline::widgets

#include "moc_gamma_slider.cpp"
