// SPDX-License-Identifier: Apache-2.0
#include "model/geometry/normals.h"

#include <glm/geometric.hpp>

#include "model/base/parallel.h"
#include "model/geometry/face_sums.h"

namespace sline::model {

namespace {
/// Returns the faces' contributions at their corners: the cross product of the corner's edges over
/// the product of their squared lengths (Max 1999, eq. for sphere-exact weights).
CornerShares normalShares(const Mesh& mesh, const FourFaces& faces) {
  const auto p = mesh.positions();
  const Corners<Vector<Lanes>> at{cornerVectors(p, faces, 0), cornerVectors(p, faces, 1),
                                  cornerVectors(p, faces, 2)};
  CornerShares shares{};
  for (std::size_t j = 0; j < 3; ++j) {
    const Vector<Lanes> toNext = at[(j + 1) % 3] - at[j];
    const Vector<Lanes> toLast = at[(j + 2) % 3] - at[j];
    const Lanes weight = dot(toNext, toNext) * dot(toLast, toLast);
    const Vector<Lanes> normal = cross(toNext, toLast) / weight;
    const auto counts = weight > 0.0f;
    shares[j] = {counts ? normal.x : Lanes{}, counts ? normal.y : Lanes{},
                 counts ? normal.z : Lanes{}, Lanes{}};
  }
  return shares;
}
}  // namespace

std::vector<glm::vec3> vertexNormals(const Mesh& mesh) {
  const std::vector<glm::vec4> sums =
      summedOverFaces(mesh, [&mesh](const FourFaces& faces) { return normalShares(mesh, faces); });
  std::vector<glm::vec3> normals(sums.size());
  parallelFor(normals.size(), 8192, [&](std::size_t v) {
    const glm::vec3 sum(sums[v]);
    const float length = glm::length(sum);
    normals[v] = length > 0.0f ? sum / length : glm::vec3(0.0f);
  });
  return normals;
}

}  // namespace sline::model
