// SPDX-License-Identifier: Apache-2.0
#include "model/geometry/mesh.h"

#include <cmath>
#include <glm/common.hpp>
#include <string>

#include "model/geometry/scale_limits.h"

namespace sline::model {

void Box::add(const glm::vec3& p) {
  low = glm::min(low, p);
  high = glm::max(high, p);
}

std::array<glm::vec3, 8> Box::corners() const {
  std::array<glm::vec3, 8> all;
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i] = {(i & 1U) != 0U ? high.x : low.x, (i & 2U) != 0U ? high.y : low.y,
              (i & 4U) != 0U ? high.z : low.z};
  return all;
}

void Box::add(const Box& other) {
  low = glm::min(low, other.low);
  high = glm::max(high, other.high);
}

namespace {
bool finite(const glm::vec3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

bool withinReach(const glm::vec3& p) {
  const glm::vec3 away = glm::abs(p);
  return away.x <= farthestCoordinate && away.y <= farthestCoordinate &&
         away.z <= farthestCoordinate;
}
}  // namespace

Result<Mesh> Mesh::create(std::vector<glm::vec3> positions, std::vector<Triangle> triangles) {
  constexpr std::size_t limit = std::size_t(1) << 31;
  if (positions.size() >= limit || triangles.size() >= limit)
    return Error{.reason = "the mesh has more than 2^31 vertices or triangles",
                 .remedy = "Simplify it or split it into parts"};
  Mesh mesh;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (!finite(positions[i]))
      return Error{.where = "vertex " + std::to_string(i),
                   .reason = "a coordinate is not a finite number",
                   .remedy = "Export the mesh again or remove this vertex"};
    if (!withinReach(positions[i]))
      return Error{.where = "vertex " + std::to_string(i),
                   .reason = "it lies more than 100 km from the origin",
                   .remedy = "Check the unit of its coordinates"};
    mesh.m_bounds.add(positions[i]);
  }
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (const std::uint32_t vertex : triangles[i])
      if (vertex >= positions.size())
        return Error{.where = "triangle " + std::to_string(i),
                     .reason = "it uses vertex " + std::to_string(vertex) +
                               ", but there are only " + std::to_string(positions.size()),
                     .remedy = "Export the mesh again"};
  mesh.m_positions = std::move(positions);
  mesh.m_triangles = std::move(triangles);
  return mesh;
}

}  // namespace sline::model
