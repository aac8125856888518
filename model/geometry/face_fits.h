// SPDX-License-Identifier: Apache-2.0
// Fits tensors to faces and sums them at vertices, four faces at a time.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "model/geometry/mesh.h"

namespace sline::model {

/// The principal directions and curvatures of all vertices.
struct Principal {
  std::vector<glm::vec3> e1;
  std::vector<glm::vec2> k;
};

/// Returns for each vertex the sum of its faces' tensors that best explain how normals differ along
/// edges (R §3), weighted by corner areas and written in the vertex's `tangentFrame`: (uu, uv, vv);
/// and the sum of the weights.
std::vector<glm::vec4> summedTensors(const Mesh& mesh, std::span<const glm::vec3> normals);

/// Returns for each vertex the sum of its faces' derivatives that best explain how the corners'
/// tensors differ (R §4: the same fit one order higher), with the same weights and written in the
/// frame of its principal directions: (uuu, uuv, uvv, vvv).
std::vector<glm::vec4> summedDerivatives(const Mesh& mesh, std::span<const glm::vec3> normals,
                                         const Principal& known);

}  // namespace sline::model
