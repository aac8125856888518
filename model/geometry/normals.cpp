// SPDX-License-Identifier: Apache-2.0
#include "model/geometry/normals.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "model/base/parallel.h"

namespace sline::model {

namespace {
/// Returns the face's contribution at corner `vertex`: the cross product of the corner's edges over
/// the product of their squared lengths (Max 1999, eq. for sphere-exact weights).
glm::vec3 cornerNormal(const Mesh& mesh, const Triangle& t, std::uint32_t vertex) {
  const std::size_t corner = t[0] == vertex ? 0 : t[1] == vertex ? 1 : 2;
  const auto positions = mesh.positions();
  const glm::vec3 p = positions[t[corner]];
  const glm::vec3 toNext = positions[t[(corner + 1) % 3]] - p;
  const glm::vec3 toLast = positions[t[(corner + 2) % 3]] - p;
  const float weight = glm::dot(toNext, toNext) * glm::dot(toLast, toLast);
  if (!(weight > 0.0f))
    return glm::vec3(0.0f);
  return glm::cross(toNext, toLast) / weight;
}
}  // namespace

std::vector<glm::vec3> vertexNormals(const Mesh& mesh, const VertexFaces& vertexFaces) {
  std::vector<glm::vec3> normals(mesh.vertexCount());
  parallelFor(mesh.vertexCount(), 4096, [&](std::size_t v) {
    glm::vec3 sum(0.0f);
    for (const std::uint32_t f : vertexFaces[v])
      sum += cornerNormal(mesh, mesh.triangles()[f], std::uint32_t(v));
    const float length = glm::length(sum);
    normals[v] = length > 0.0f ? sum / length : glm::vec3(0.0f);
  });
  return normals;
}

}  // namespace sline::model
