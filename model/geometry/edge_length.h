// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "model/geometry/mesh.h"

namespace sline::model {

/// Returns the mean length of the edges, counting all three of each triangle, in the unit of the
/// positions; 0 without triangles.
float meanEdgeLength(std::span<const glm::vec3> positions, std::span<const Triangle> triangles);

}  // namespace sline::model
