// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "model/fairing/half_edges.h"
#include "model/geometry/mesh.h"

namespace sline::model {

struct Orientation {
  std::size_t turned = 0;
  bool notOrientable = false;
};

/// Turns triangles so that neighbours agree; in each piece the majority by area decides. Closed
/// pieces face outward by their signed volume, those inside an odd number of others (parity of the
/// crossings of a ray, METHOD §1) inward. Pieces without a consistent orientation stay as they are.
Orientation orient(std::span<const glm::vec3> positions, std::span<Triangle> triangles,
                   const HalfEdges& edges);

}  // namespace sline::model
