// SPDX-License-Identifier: Apache-2.0
#include "model/scene/section.h"

#include <cmath>

namespace sline::model {

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
