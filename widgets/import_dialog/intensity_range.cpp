// SPDX-License-Identifier: Apache-2.0
#include "widgets/import_dialog/intensity_range.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace sline::widgets {

namespace {
constexpr int rangeMargin = 6;
constexpr std::size_t bins = 256;
}  // namespace

IntensityRange::IntensityRange(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("intensityRange"));
  setAccessibleName(tr("Intensities"));
  setToolTip(
      tr("How often each intensity occurs. Drag the bounds; on the keyboard the arrows move "
         "the lower one, with Shift the upper one"));
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QSize IntensityRange::sizeHint() const {
  return {420, 96};
}

QSize IntensityRange::minimumSizeHint() const {
  return {180, 96};
}

void IntensityRange::setHistogram(const model::GreyHistogram& histogram) {
  // A few voxels of metal would leave no room for all others.
  m_least = histogram.least();
  m_greatest = std::max(histogram.quantile(0.9999, m_least), m_least + 1e-9);
  m_counts = histogram.binned(m_least, m_greatest, bins);
  update();
}

void IntensityRange::setBounds(const model::IntensityBounds& bounds) {
  m_bounds = bounds;
  update();
}

int IntensityRange::placeOf(double intensity) const {
  const double at = (intensity - m_least) / (m_greatest - m_least);
  return rangeMargin + int(std::clamp(at, 0.0, 1.0) * (width() - 2 * rangeMargin));
}

double IntensityRange::intensityAt(double pixel) const {
  const double at = (pixel - rangeMargin) / std::max(1, width() - 2 * rangeMargin);
  return m_least + std::clamp(at, 0.0, 1.0) * (m_greatest - m_least);
}

void IntensityRange::move(bool upper, double to) {
  model::IntensityBounds bounds = m_bounds;
  const double step = (m_greatest - m_least) / 1000.0;
  to = std::abs(to) >= 10.0 * step && step > 0.01 ? std::round(to) : to;
  if (upper)
    bounds.high =
        to >= m_greatest ? std::nullopt : std::optional(std::max(to, bounds.low.value_or(m_least)));
  else
    bounds.low = std::min(std::max(to, m_least), highShown());
  setBounds(bounds);
  emit boundsChanged(bounds);
}

void IntensityRange::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const QPalette& colours = palette();
  painter.fillRect(rect(), colours.color(QPalette::Base));
  const int low = placeOf(lowShown());
  const int high = placeOf(highShown());
  QColor within = colours.color(QPalette::Highlight);
  within.setAlpha(50);
  painter.fillRect(QRect(low, 0, high - low, height()), within);
  std::uint64_t most = 1;
  for (const std::uint64_t count : m_counts)
    most = std::max(most, count);
  const double top = std::log1p(double(most));
  painter.setPen(Qt::NoPen);
  const double wide = double(width() - 2 * rangeMargin) / double(bins);
  for (std::size_t i = 0; i < m_counts.size(); ++i) {
    const double tall = std::log1p(double(m_counts[i])) / top * (height() - 12);
    const double x = rangeMargin + wide * double(i);
    const bool in = x + 0.5 * wide >= low && x + 0.5 * wide <= high;
    painter.setBrush(colours.color(in ? QPalette::Highlight : QPalette::Mid));
    painter.drawRect(QRectF(x, height() - tall, wide + 0.5, tall));
  }
  painter.setRenderHint(QPainter::Antialiasing);
  for (const int x : {low, high}) {
    painter.setPen(QPen(colours.color(QPalette::Text), 2.0));
    painter.drawLine(x, 0, x, height());
    painter.setBrush(colours.color(QPalette::Text));
    painter.setPen(Qt::NoPen);
    painter.drawEllipse(QPointF(x, 6.0), 5.0, 5.0);
  }
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(colours.color(hasFocus() ? QPalette::Highlight : QPalette::Mid),
                      hasFocus() ? 2.0 : 1.0));
  painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

void IntensityRange::mousePressEvent(QMouseEvent* event) {
  const double x = event->position().x();
  const double toLow = std::abs(x - placeOf(lowShown()));
  const double toHigh = std::abs(x - placeOf(highShown()));
  m_upper = toHigh < toLow || (toHigh == toLow && x > placeOf(highShown()));
  move(m_upper, intensityAt(x));
}

void IntensityRange::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() & Qt::LeftButton)
    move(m_upper, intensityAt(event->position().x()));
}

void IntensityRange::keyPressEvent(QKeyEvent* event) {
  const int way = event->key() == Qt::Key_Right ? 1 : event->key() == Qt::Key_Left ? -1 : 0;
  if (way == 0)
    return QWidget::keyPressEvent(event);
  const bool upper = event->modifiers() & Qt::ShiftModifier;
  const double step = (m_greatest - m_least) / 500.0;
  const double times = event->modifiers() & Qt::ControlModifier ? 10.0 : 1.0;
  move(upper, (upper ? highShown() : lowShown()) + way * times * std::max(step, 1e-12));
}

}  // namespace sline::widgets

#include "moc_intensity_range.cpp"
