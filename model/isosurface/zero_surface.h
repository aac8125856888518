// SPDX-License-Identifier: Apache-2.0
// The surface where a sampled field is zero (flying edges, Schroeder, Maynard and Geveci 2015, as
// VTK has it).
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "model/geometry/mesh.h"

namespace sline::model {

/// A field's values at the nodes of a box-shaped grid, x fastest; `values` outlives its use.
struct SampledBox {
  glm::ivec3 size{0};      ///< nodes along each axis; as many values as their product
  glm::dvec3 origin{0.0};  ///< of the first node
  glm::dvec3 step{1.0};    ///< from node to node
  std::span<const float> values;
};

struct ZeroSurface {
  std::vector<glm::vec3> positions;
  std::vector<Triangle> triangles;
};

/// In the grid's coordinates; which way round the triangles go is not promised.
ZeroSurface zeroSurface(const SampledBox& box);

}  // namespace sline::model
