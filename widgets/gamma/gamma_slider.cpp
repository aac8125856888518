// SPDX-License-Identifier: Apache-2.0
#include "widgets/gamma/gamma_slider.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "widgets/gamma/stages.h"

namespace sline::widgets {

namespace {

constexpr int unitsPerGamma = 100;
constexpr double margin = 16.0;  // above and below the groove: half a handle and half a line
constexpr double grooveX = 20.0;
constexpr double handleRadius = 9.0;
constexpr double labelX = 46.0;

Gamma fromUnits(int units) {
  return Gamma::clamped(float(units) / unitsPerGamma);
}

int toUnits(Gamma gamma) {
  return int(std::lround(gamma.value() * unitsPerGamma));
}

}  // namespace

GammaSlider::GammaSlider(QWidget* parent) : QAbstractSlider(parent) {
  setOrientation(Qt::Vertical);
  setRange(0, 5 * unitsPerGamma);
  setSingleStep(unitsPerGamma / 20);
  setPageStep(unitsPerGamma);
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Expanding);
  setAttribute(Qt::WA_Hover);
  connect(this, &QAbstractSlider::actionTriggered, this, [this](int action) {
    if (action != SliderMove && action != SliderNoAction)
      emit stepped(fromUnits(sliderPosition()));
  });
}

void GammaSlider::showGamma(const model::GammaRange& range, bool own) {
  m_range = range;
  m_own = own;
  const QSignalBlocker quiet(this);
  setValue(toUnits(Gamma::clamped(0.5f * (range.low.value() + range.high.value()))));
  update();
}

QSize GammaSlider::sizeHint() const {
  return {220, 320};
}

QSize GammaSlider::minimumSizeHint() const {
  return {190, 210};
}

QPointF GammaSlider::pointOf(Gamma gamma) const {
  const double length = height() - 2.0 * margin;
  return {grooveX, margin + length * (1.0 - double(gamma.value()) / 5.0)};
}

Gamma GammaSlider::gammaAt(const QPointF& point) const {
  const double length = std::max(1.0, height() - 2.0 * margin);
  const double gamma = 5.0 * (1.0 - (point.y() - margin) / length);
  return fromUnits(int(std::lround(gamma * unitsPerGamma)));
}

void GammaSlider::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  paintGroove(painter);
  paintStages(painter);
  if (isEnabled())
    paintHandle(painter);
}

void GammaSlider::paintGroove(QPainter& painter) const {
  const QPointF top = pointOf(Gamma::clamped(5.0f));
  const QPointF bottom = pointOf(Gamma::clamped(0.0f));
  painter.setPen(QPen(palette().color(QPalette::Mid), 4.0, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(top, bottom);
  if (!isEnabled())
    return;
  painter.setPen(QPen(palette().color(QPalette::Highlight), 4.0, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(m_range.low == m_range.high ? bottom : pointOf(m_range.low),
                   pointOf(m_range.high));
}

void GammaSlider::paintStages(QPainter& painter) const {
  // Halfway between two, the stage that is reached counts.
  const int nearest = int(std::ceil(m_range.high.value() - 0.5f));
  const bool one = m_range.low == m_range.high && isEnabled();
  for (const Stage& stage : gammaStages()) {
    const QPointF at = pointOf(Gamma::clamped(stage.gamma));
    painter.setPen(QPen(palette().color(QPalette::Mid), 1.0));
    painter.drawLine(at + QPointF(13.0, 0.0), at + QPointF(20.0, 0.0));
    QFont bold = font();
    bold.setBold(one && int(stage.gamma) == nearest);
    painter.setFont(bold);
    painter.setPen(
        palette().color(isEnabled() ? QPalette::Active : QPalette::Disabled, QPalette::WindowText));
    const QRectF box(labelX, at.y() - 14.0, width() - labelX, 28.0);
    painter.drawText(box, Qt::AlignVCenter | Qt::AlignLeft, stage.name);
  }
}

void GammaSlider::paintHandle(QPainter& painter) const {
  const bool one = m_range.low == m_range.high;
  const QPointF at = pointOf(fromUnits(sliderPosition()));
  const QColor accent = palette().color(QPalette::Highlight);
  if (hasFocus()) {
    QColor glow = accent;
    glow.setAlpha(70);
    painter.setPen(Qt::NoPen);
    painter.setBrush(glow);
    painter.drawEllipse(at, handleRadius + 4.0, handleRadius + 4.0);
  }
  // Filled: said here; a ring: comes from above, or differs from item to item.
  painter.setPen(QPen(accent, 2.0));
  painter.setBrush(m_own && one ? accent : palette().color(QPalette::Base));
  painter.drawEllipse(at, handleRadius - 1.0, handleRadius - 1.0);
}

void GammaSlider::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton)
    return;
  setSliderDown(true);
  emit dragStarted();
  mouseMoveEvent(event);
}

void GammaSlider::mouseMoveEvent(QMouseEvent* event) {
  if (!isSliderDown())
    return;
  // The names snap to their stage; the groove does not.
  Gamma gamma = gammaAt(event->position());
  if (event->position().x() > labelX)
    gamma = Gamma::clamped(std::round(gamma.value()));
  emit dragged(gamma);
}

void GammaSlider::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !isSliderDown())
    return;
  setSliderDown(false);
  emit dragFinished();
}

void GammaSlider::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && isSliderDown()) {
    setSliderDown(false);
    emit dragCancelled();
    return;
  }
  QAbstractSlider::keyPressEvent(event);
}

}  // namespace sline::widgets
