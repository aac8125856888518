// SPDX-License-Identifier: Apache-2.0
// Writes structure sets for the tests, and contours of simple bodies.
#pragma once

#include <QByteArray>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "model/base/units.h"
#include "tests/model/import/dicom/written_dicom.h"

namespace sline::test {

struct WrittenRegion {
  QByteArray name;
  QByteArray type = "ORGAN";
  std::optional<Colour> colour;
  std::vector<std::vector<glm::dvec3>> contours;
  QByteArray geometry = "CLOSED_PLANAR";
};
WrittenSet structureSet(const std::vector<WrittenRegion>& regions);

/// Returns corners of a circle in the plane z, counter-clockwise.
std::vector<glm::dvec3> circle(const glm::dvec3& centre, double radius, int corners = 60);
/// Returns a ball cut at z = first, first + step, …
std::vector<std::vector<glm::dvec3>> ball(const glm::dvec3& centre, double radius, double first,
                                          double step);
std::vector<std::vector<glm::dvec3>> rod(const glm::dvec3& centre, double radius,
                                         const std::vector<double>& heights);

}  // namespace sline::test
