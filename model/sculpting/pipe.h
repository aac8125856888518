// SPDX-License-Identifier: Apache-2.0
// A vessel cut off at both ends as rows of triangles around it. On a long, even tube curvature
// along it is next to nothing beside that around it, and whatever is uneven in its triangles shows.
#pragma once

#include <array>
#include <glm/vec3.hpp>

#include "model/sculpting/implicit.h"
#include "model/sculpting/remesh.h"

namespace sline::model {

/// Where a vessel goes over into the next, or is cut: the normal points out of the vessel.
struct PipeEnd {
  glm::vec3 point;
  glm::vec3 normal;
};

/// Between the ends, first and last along the course, the wall of that thickness (mm) within the
/// radius that the course carries; closed, edges about `edge` mm long.
Facets pipe(const Curve& course, float wall, const std::array<PipeEnd, 2>& ends, float edge);

}  // namespace sline::model
