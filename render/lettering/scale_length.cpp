// SPDX-License-Identifier: Apache-2.0
#include "render/lettering/scale_length.h"

#include <cmath>

namespace sline::render {

double roundStep(double most) {
  const double decade = std::pow(10.0, std::floor(std::log10(most)));
  for (const double step : {5.0, 2.0})
    if (step * decade <= most * (1.0 + 1e-9))
      return step * decade;
  return decade;
}

std::optional<ScaleLength> scaleLength(const model::Camera& camera, const glm::vec3& at,
                                       double height, double most) {
  const double scale = double(model::millimetresPerPixel(camera, at, float(height)));
  if (!(scale > 0.0) || !std::isfinite(scale))
    return std::nullopt;
  const double millimetres = roundStep(scale * most);
  return ScaleLength{.millimetres = millimetres, .drawn = millimetres / scale};
}

std::optional<glm::vec3> scalePlace(const model::Scene& scene) {
  const model::Box bounds = scene.visibleBounds();
  return bounds.empty() ? std::nullopt : std::optional(bounds.centre());
}

QString lengthText(double millimetres, const QLocale& locale, model::DrawnUnit unit) {
  const bool angstrom = unit == model::DrawnUnit::angstrom;
  const bool doubted = unit == model::DrawnUnit::doubtedMillimetre;
  const int digits = angstrom ? 9 : 4;
  const auto text = [&](double value, std::string_view symbol) {
    return locale.toString(value, 'g', digits) + QLatin1Char(' ') +
           QString::fromUtf8(symbol.data(), qsizetype(symbol.size())) +
           (doubted ? QStringLiteral("?") : QString());
  };
  if (angstrom)
    return text(millimetres, symbolOf(unit));
  if (millimetres >= 1000.0)
    return text(millimetres / 1000.0, "m");
  if (millimetres >= 10.0)
    return text(millimetres / 10.0, "cm");
  return text(millimetres, "mm");
}

}  // namespace sline::render
