// SPDX-License-Identifier: Apache-2.0
// Meshes a vessel cut off at both ends as rows of triangles around it. On a long, even tube the
// curvature along it is almost nothing compared with that around it, and any unevenness of its
// triangles shows.
#pragma once

#include <array>
#include <glm/vec3.hpp>

#include "model/sculpting/implicit.h"
#include "model/sculpting/remesh.h"

namespace sline::model {

/// Describes the end where a vessel continues as the next, or is cut: the normal points out of the
/// vessel.
struct PipeEnd {
  glm::vec3 point;
  glm::vec3 normal;
};

/// Meshes the wall of that thickness (mm) between the ends, first and last along the course, within
/// the radius that the course carries; it is closed, with edges about `edge` mm long.
Facets pipe(const Curve& course, float wall, const std::array<PipeEnd, 2>& ends, float edge);

}  // namespace sline::model
