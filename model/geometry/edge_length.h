// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "model/geometry/mesh.h"

namespace sline::model {

/// Mean length of the triangles' edges, each triangle's three counted; 0 without triangles. In the
/// unit of the positions.
float meanEdgeLength(std::span<const glm::vec3> positions, std::span<const Triangle> triangles);

}  // namespace sline::model
