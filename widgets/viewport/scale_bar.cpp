// SPDX-License-Identifier: Apache-2.0
#include "widgets/viewport/scale_bar.h"

#include <QPainter>
#include <QPainterPath>
#include <cmath>

namespace sline::widgets {

namespace {
constexpr int margin = 3;  ///< around the bar, so that nothing is cut off
constexpr int tick = 7;    ///< height of the bar's ends
}  // namespace

double roundStep(double most) {
  const double decade = std::pow(10.0, std::floor(std::log10(most)));
  for (const double step : {5.0, 2.0})
    if (step * decade <= most * (1.0 + 1e-9))
      return step * decade;
  return decade;
}

std::optional<ScaleBar> scaleBar(const model::Camera& camera, const glm::vec3& at,
                                 double heightPixels, double mostPixels) {
  const double scale = double(model::millimetresPerPixel(camera, at, float(heightPixels)));
  if (!(scale > 0.0) || !std::isfinite(scale))
    return std::nullopt;
  const double millimetres = roundStep(scale * mostPixels);
  return ScaleBar{.millimetres = millimetres, .pixels = millimetres / scale};
}

QString lengthText(double millimetres, const QLocale& locale) {
  constexpr int digits = 4;
  const auto number = [&](double value) { return locale.toString(value, 'g', digits); };
  if (millimetres >= 1000.0)
    return ScaleBarMark::tr("%1 m").arg(number(millimetres / 1000.0));
  if (millimetres >= 10.0)
    return ScaleBarMark::tr("%1 cm").arg(number(millimetres / 10.0));
  return ScaleBarMark::tr("%1 mm").arg(number(millimetres));
}

ScaleBarMark::ScaleBarMark(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("scaleBar"));
  setAttribute(Qt::WA_TransparentForMouseEvents);
}

void ScaleBarMark::show(const std::optional<ScaleBar>& bar) {
  m_bar = bar;
  setAccessibleName(bar ? tr("Scale: %1").arg(lengthText(bar->millimetres, QLocale())) : QString());
  update();
}

void ScaleBarMark::setInk(const QColor& ink) {
  m_ink = ink;
  update();
}

QSize ScaleBarMark::sizeHint() const {
  return {most + 2 * margin, fontMetrics().height() + tick + 2 * margin};
}

void ScaleBarMark::paintEvent(QPaintEvent*) {
  if (!m_bar)
    return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const double left = margin + 0.5;
  const double right = left + m_bar->pixels;
  const double foot = height() - margin - 0.5;
  QPainterPath path(QPointF(left, foot - tick));
  path.lineTo(left, foot);
  path.lineTo(right, foot);
  path.lineTo(right, foot - tick);
  painter.setPen(QPen(m_ink, 1.2));
  painter.drawPath(path);
  painter.drawText(QRectF(left + 5.0, 0.0, width(), foot - 3.0), Qt::AlignLeft | Qt::AlignBottom,
                   lengthText(m_bar->millimetres, QLocale()));
}

}  // namespace sline::widgets
