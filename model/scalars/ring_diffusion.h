// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "model/fairing/vertex_rings.h"

namespace sline::model {

/// Replaces each vertex's values, so many times over, by the mean of themselves and the mean of its
/// neighbours'. After n steps the values are as if filtered by a Gaussian with a deviation of half
/// of √n edges. Vertices without neighbours keep theirs.
void diffuse(const VertexRings& rings, int steps, std::vector<glm::vec2>& values);

}  // namespace sline::model
