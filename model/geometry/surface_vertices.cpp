// SPDX-License-Identifier: Apache-2.0
#include "model/geometry/surface_vertices.h"

#include <glm/geometric.hpp>

#include "model/base/parallel.h"

namespace sline::model {

std::array<float, 6> shapeOperator(const SurfaceVertex& vertex) {
  const glm::vec3 e1 = vertex.e1;
  const glm::vec3 e2 = glm::cross(vertex.normal, e1);
  const glm::vec3 a = vertex.k.x * e1;
  const glm::vec3 b = vertex.k.y * e2;
  return {a.x * e1.x + b.x * e2.x, a.x * e1.y + b.x * e2.y, a.x * e1.z + b.x * e2.z,
          a.y * e1.y + b.y * e2.y, a.y * e1.z + b.y * e2.z, a.z * e1.z + b.z * e2.z};
}

SurfaceVertices::SurfaceVertices(std::span<const glm::vec3> positions,
                                 std::span<const glm::vec3> normals, const Curvature& curvature)
    : m_vertices(positions.size()) {
  parallelFor(positions.size(), 8192, [&](std::size_t v) {
    m_vertices[v] = {.position = positions[v],
                     .normal = normals[v],
                     .e1 = curvature.e1[v],
                     .k = curvature.k[v],
                     .derivative = curvature.derivative[v]};
  });
}

SurfaceVertices::SurfaceVertices(std::span<const SurfaceVertex> finer,
                                 std::span<const std::uint32_t> places)
    : m_vertices(places.size()) {
  parallelFor(places.size(), 8192, [&](std::size_t v) { m_vertices[v] = finer[places[v]]; });
}

}  // namespace sline::model
