// SPDX-License-Identifier: Apache-2.0
#include "model/geometry/face_neighbours.h"

#include "model/base/parallel.h"
#include "model/geometry/topology.h"

namespace sline::model {

namespace {
/// Returns the only triangle besides `self` that runs along the edge from b to a, or `none`.
std::uint32_t neighbour(const Mesh& mesh, const VertexFaces& faces, std::uint32_t self,
                        const std::array<std::uint32_t, 2>& edge) {
  std::uint32_t found = FaceNeighbours::none;
  // Both ends list all triangles of the edge. The shorter list is looked through, as otherwise each
  // of many triangles around one vertex would look at all others.
  const std::uint32_t end = faces[edge[0]].size() <= faces[edge[1]].size() ? edge[0] : edge[1];
  for (const std::uint32_t f : faces[end]) {
    if (f == self)
      continue;
    const Triangle& t = mesh.triangles()[f];
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t from = t[c];
      const std::uint32_t to = t[(c + 1) % 3];
      const bool opposed = from == edge[1] && to == edge[0];
      const bool alike = from == edge[0] && to == edge[1];
      if (alike || (opposed && found != FaceNeighbours::none))
        return FaceNeighbours::none;
      if (opposed)
        found = f;
    }
  }
  return found;
}
}  // namespace

FaceNeighbours::FaceNeighbours(const Mesh& mesh) : m_across(mesh.triangleCount()) {
  const VertexFaces faces(mesh);
  parallelFor(mesh.triangleCount(), 4096, [&](std::size_t i) {
    const Triangle& t = mesh.triangles()[i];
    for (std::size_t c = 0; c < 3; ++c)
      m_across[i][c] = neighbour(mesh, faces, std::uint32_t(i), {t[(c + 1) % 3], t[(c + 2) % 3]});
  });
}

}  // namespace sline::model
