// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "model/geometry/mesh.h"

namespace sline::model {

/// Returns how far each point lies from the nearest of the surfaces, in millimetres and at least 0
/// on either side of them; infinity where none has a triangle.
std::vector<float> distancesTo(std::span<const MeshPtr> targets, std::span<const glm::vec3> points);

}  // namespace sline::model
