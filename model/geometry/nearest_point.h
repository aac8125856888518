// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>

#include "model/geometry/mesh.h"

namespace sline::model {

/// Holds a point of a mesh.
struct PointOnMesh {
  std::uint32_t triangle = 0;
  std::array<float, 2>
      weights{};  ///< barycentric weights of the triangle's second and third corner
  glm::vec3 place{0.0f};
};

/// Returns the point of the surface nearest to `p`; of several the one in the first triangle; none
/// where the mesh has no triangle.
std::optional<PointOnMesh> nearestPoint(const Mesh& mesh, const glm::vec3& p);

/// Returns the point of that triangle nearest to `p`.
PointOnMesh nearestPointIn(const Mesh& mesh, std::uint32_t triangle, const glm::vec3& p);

}  // namespace sline::model
