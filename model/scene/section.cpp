// SPDX-License-Identifier: Apache-2.0
#include "model/scene/section.h"

#include <algorithm>
#include <cmath>

namespace sline::model {

std::optional<CutFaces> cutFacesNamed(std::string_view name) {
  const auto* const found = std::find(cutFacesNames.begin(), cutFacesNames.end(), name);
  return found == cutFacesNames.end() ? std::nullopt
                                      : std::optional(CutFaces(found - cutFacesNames.begin()));
}

int axisOf(AnatomicalView side) {
  switch (side) {
    case AnatomicalView::left:
    case AnatomicalView::right:
      return 0;
    case AnatomicalView::anterior:
    case AnatomicalView::posterior:
      return 1;
    case AnatomicalView::superior:
    case AnatomicalView::inferior:
      break;
  }
  return 2;
}

Plane anatomicalPlane(AnatomicalView kept, float mm) {
  // LPS grows to the left, the back and the head: these sides are kept where the coordinate is
  // larger, so the normal points to where it is smaller.
  const bool larger = kept == AnatomicalView::left || kept == AnatomicalView::posterior ||
                      kept == AnatomicalView::superior;
  Plane plane;
  plane.normal = glm::vec3(0.0f);
  plane.normal[axisOf(kept)] = larger ? -1.0f : 1.0f;
  plane.offset = larger ? -mm : mm;
  return plane;
}

std::optional<int> axisAcross(const Plane& plane) {
  constexpr float parallel = 0.99999f;
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(plane.normal[axis]) > parallel)
      return axis;
  return std::nullopt;
}

std::optional<AnatomicalView> keptSide(const Plane& plane) {
  using enum AnatomicalView;
  const std::optional<int> axis = axisAcross(plane);
  if (!axis)
    return std::nullopt;
  static constexpr std::array<AnatomicalView, 3> smaller{right, anterior, inferior};
  static constexpr std::array<AnatomicalView, 3> larger{left, posterior, superior};
  return (plane.normal[*axis] > 0.0f ? smaller : larger)[std::size_t(*axis)];
}

double positionOf(const Plane& plane) {
  const std::optional<int> axis = axisAcross(plane);
  const bool against = axis && plane.normal[*axis] < 0.0f;
  return against ? -double(plane.offset) : double(plane.offset);
}

std::vector<Plane> planesOf(std::span<const Section> sections) {
  std::vector<Plane> planes;
  for (const Section& section : sections)
    planes.push_back(section.plane);
  return planes;
}

std::optional<std::string_view> planeFault(const Plane& plane) {
  const glm::vec3& n = plane.normal;
  if (!std::isfinite(n.x) || !std::isfinite(n.y) || !std::isfinite(n.z) ||
      !std::isfinite(plane.offset))
    return "a number of the plane is not finite";
  if (!(std::abs(glm::length(glm::dvec3(n)) - 1.0) < 1e-4))
    return "the plane's normal is not a unit vector";
  return std::nullopt;
}

}  // namespace sline::model
