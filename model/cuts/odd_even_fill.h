// SPDX-License-Identifier: Apache-2.0
// Fills outlines in the plane by the odd-even rule: a point is inside if a ray from it to the
// outside meets the outline an odd number of times. Nested loops give holes, and islands in them;
// edges may cross or be left over, which shifts the fill by no more than the length of such edges.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "model/geometry/mesh.h"

namespace sline::model {

/// Holds triangles without T-junctions: where two of them touch, they share whole edges.
struct FlatFill {
  std::vector<glm::dvec2> points;
  std::vector<Triangle> triangles;  ///< counter-clockwise
  double area = 0.0;
};

/// Fills the outline given by its edges, which may come in any order and direction; the edges of a
/// loop share their ends to the last bit.
FlatFill oddEvenFill(std::span<const std::array<glm::dvec2, 2>> edges);

}  // namespace sline::model
