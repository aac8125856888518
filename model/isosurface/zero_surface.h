// SPDX-License-Identifier: Apache-2.0
// Extracts the surface where a sampled field is zero (flying edges, Schroeder, Maynard and Geveci
// 2015, in VTK's implementation).
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "model/geometry/mesh.h"

namespace sline::model {

/// Holds a field's values at the nodes of a box-shaped grid, x fastest; the memory behind `values`
/// must outlive its use.
struct SampledBox {
  glm::ivec3 size{0};      ///< nodes along each axis; their product is the number of values
  glm::dvec3 origin{0.0};  ///< position of the first node
  glm::dvec3 step{1.0};    ///< distance between neighbouring nodes
  std::span<const float> values;
};

struct ZeroSurface {
  std::vector<glm::vec3> positions;
  std::vector<Triangle> triangles;
};

/// Returns the surface in the grid's coordinates; the orientation of the triangles is not promised.
ZeroSurface zeroSurface(const SampledBox& box);

}  // namespace sline::model
