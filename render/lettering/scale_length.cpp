// SPDX-License-Identifier: Apache-2.0
#include "render/lettering/scale_length.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "model/lengths/told_length.h"

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

std::optional<ScalePlace> ScalePlaces::in(const model::Camera& camera) const {
  if (!middle)
    return std::nullopt;
  ScalePlace place{.at = *middle};
  float most = 0.8f;  // the cosine from which on a face is what the picture shows
  for (const model::Plane& plane : planes) {
    const glm::vec3 on = *middle - float(plane.distance(*middle)) * plane.normal;
    const float facing = glm::dot(plane.normal, model::towardsEye(camera, on));
    if (facing <= most)
      continue;
    most = facing;
    place = {.at = on, .onCutFace = true};
  }
  return place;
}

ScalePlaces scalePlaces(const model::Scene& scene) {
  const model::Box bounds = scene.visibleBounds();
  ScalePlaces places;
  if (bounds.empty())
    return places;
  places.middle = bounds.centre();
  for (const model::Section& section : scene.sections()) {
    const model::Box cut = scene.visibleBounds(section.scope);
    if (cut.empty())
      continue;
    const auto corners = cut.corners();
    const auto keeps = [&](const glm::vec3& corner) { return section.plane.keeps(corner); };
    const bool all = std::all_of(corners.begin(), corners.end(), keeps);
    const bool none = std::none_of(corners.begin(), corners.end(), keeps);
    if (section.enabled && !all && !none)
      places.planes.push_back(section.plane);
  }
  return places;
}

QString lengthText(double millimetres, const QLocale& locale, model::DrawnUnit unit) {
  const bool angstrom = unit == model::DrawnUnit::angstrom;
  const model::ToldUnit told = model::toldUnit(millimetres, unit);
  const int digits = angstrom ? 9 : 4;
  const auto text = [&](double value, std::string_view symbol) {
    return locale.toString(value, 'g', digits) + QLatin1Char(' ') +
           QString::fromUtf8(symbol.data(), qsizetype(symbol.size())) +
           (told.doubted ? QStringLiteral("?") : QString());
  };
  if (angstrom)
    return text(millimetres, told.symbol);
  if (millimetres >= 1000.0)
    return text(millimetres / 1000.0, "m");
  if (millimetres >= 10.0)
    return text(millimetres / 10.0, "cm");
  // A round number of a smaller unit is not quite round after the division.
  return text(
      told.millimetres < 1.0 ? std::round(1e6 * millimetres / told.millimetres) / 1e6 : millimetres,
      told.symbol);
}

}  // namespace sline::render
