// SPDX-License-Identifier: Apache-2.0
#include "model/meshing/cut_surface.h"

#include <utility>

#include "model/fairing/half_edges.h"

namespace sline::model {

namespace {
constexpr std::uint32_t uncut = 0xffffffffu;

std::uint32_t previousInTriangle(std::uint32_t halfEdge) {
  return halfEdge % 3 == 0 ? halfEdge + 2 : halfEdge - 1;
}

/// Returns the half-edges that lie across from each other and run in opposite directions, in two
/// triangles.
std::vector<std::uint32_t> twoSided(std::span<const Triangle> triangles, const HalfEdges& edges) {
  const auto from = [&](std::uint32_t h) { return triangles[h / 3][h % 3]; };
  std::vector<std::uint32_t> opposites(edges.count(), HalfEdges::open);
  for (std::uint32_t h = 0; h < edges.count(); ++h) {
    if (!edges.hasOpposite(h))
      continue;
    const std::uint32_t other = edges.opposite(h);
    if (other / 3 != h / 3 && from(other) != from(h))
      opposites[h] = other;
  }
  return opposites;
}

/// Gives the vertex to all corners of the fan around `start`. Returns true where the fan is open.
bool walkFan(CutSurface& cut, std::uint32_t start, std::uint32_t vertex) {
  std::uint32_t corner = start;
  for (;;) {
    cut.corners[corner] = vertex;
    corner = cut.opposites[previousInTriangle(corner)];
    if (corner == start)
      return false;
    if (corner == HalfEdges::open)
      break;
  }
  for (corner = cut.opposites[start]; corner != HalfEdges::open; corner = cut.opposites[corner]) {
    corner = nextInTriangle(corner);
    cut.corners[corner] = vertex;
  }
  return true;
}
}  // namespace

CutSurface cutOpen(std::size_t vertexCount, std::span<const Triangle> triangles) {
  CutSurface cut;
  cut.opposites = twoSided(triangles, HalfEdges(vertexCount, triangles));
  cut.corners.assign(cut.opposites.size(), uncut);
  cut.originals.reserve(vertexCount);
  cut.copies.reserve(vertexCount);
  cut.rims.reserve(vertexCount);
  std::vector<std::uint32_t> last(vertexCount, uncut);
  for (std::uint32_t corner = 0; corner < cut.corners.size(); ++corner) {
    if (cut.corners[corner] != uncut)
      continue;
    const std::uint32_t original = triangles[corner / 3][corner % 3];
    const auto vertex = std::uint32_t(cut.originals.size());
    cut.originals.push_back(original);
    cut.copies.push_back(vertex);
    if (last[original] != uncut)
      std::swap(cut.copies[vertex], cut.copies[last[original]]);
    last[original] = vertex;
    cut.rims.push_back(walkFan(cut, corner, vertex) ? 1 : 0);
  }
  return cut;
}

}  // namespace sline::model
