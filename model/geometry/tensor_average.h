// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "model/base/lanes.h"
#include "model/geometry/mesh.h"
#include "model/geometry/tangent_tensors.h"

namespace sline::model {

/// Averages vertices' tensors with those of the vertices around them. How their `tangentFrame`s are
/// turned against each other is found once for all steps.
class TensorAverage {
 public:
  TensorAverage(const Mesh& mesh, std::span<const glm::vec3> normals);

  /// Takes a step; a tensor is (uu, uv, vv). A neighbour counts as much as the vertex itself, or
  /// less or more where not exactly two triangles share the edge to it.
  void step(std::vector<glm::vec3>& tensors) const;

 private:
  const Mesh& m_mesh;
  /// Of four faces, corner by corner: of its frame, in that of the next corner.
  std::vector<std::array<Turn<Lanes>, 3>> m_turns;
};

}  // namespace sline::model
