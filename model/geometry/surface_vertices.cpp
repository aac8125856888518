// SPDX-License-Identifier: Apache-2.0
#include "model/geometry/surface_vertices.h"

#include "model/base/parallel.h"

namespace sline::model {

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

}  // namespace sline::model
