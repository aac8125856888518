// SPDX-License-Identifier: Apache-2.0
// Smooths positions of which none may leave its place by more than a limit.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "model/fairing/vertex_rings.h"

namespace sline::model {

/// Pulls each vertex back until it is no farther from `before` than its limit; both in one unit.
void limitMoves(std::vector<glm::vec3>& after, std::span<const glm::vec3> before,
                std::span<const float> limits);

/// Smooths the positions within the limits, since cutting moves off at them leaves kinks. Rounds of
/// low-pass and limit together lead to a smooth surface, as in S. Gibson, "Constrained Elastic
/// Surface Nets" (1998), but with G. Taubin's pair of steps (1995), which does not shrink. Vertices
/// on borders stay.
void relaxWithin(std::vector<glm::vec3>& positions, std::span<const glm::vec3> before,
                 std::span<const float> limits, const VertexRings& rings);

}  // namespace sline::model
