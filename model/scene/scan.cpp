// SPDX-License-Identifier: Apache-2.0
#include "model/scene/scan.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace sline::model {

glm::dvec3 Scan::spacing() const {
  return {glm::length(glm::dvec3(toLps[0])), glm::length(glm::dvec3(toLps[1])),
          glm::length(glm::dvec3(toLps[2]))};
}

std::string scanFault(const Scan& scan) {
  std::uint64_t count = 1;
  for (int axis = 0; axis < 3; ++axis) {
    if (scan.size[axis] < 1 || std::uint64_t(scan.size[axis]) > mostScanVoxels / count)
      return "its size is not one of voxels";
    count *= std::uint64_t(scan.size[axis]);
  }
  if (!scan.voxels || scan.voxels->size() != count)
    return "it has not as many voxels as its size says";
  if (!std::isfinite(scan.slope) || !std::isfinite(scan.intercept) || scan.slope == 0.0)
    return "its intensities have no scale";
  constexpr double farthest = 1e7;
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row)
      if (!(std::abs(scan.toLps[column][row]) < farthest))
        return "its place is none in millimetres";
  const glm::dvec3 sides = scan.spacing();
  if (!(std::abs(glm::determinant(glm::dmat3(scan.toLps))) > 1e-4 * sides.x * sides.y * sides.z))
    return "its voxels do not span space";
  return {};
}

}  // namespace sline::model
