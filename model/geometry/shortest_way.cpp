// SPDX-License-Identifier: Apache-2.0
#include "model/geometry/shortest_way.h"

#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "model/geometry/mesh_trees.h"

namespace sline::model {

namespace {

/// Holds a corner and how far it is from the other surface.
struct NearCorner {
  std::uint32_t triangle = 0;
  glm::vec3 place{0.0f};
  float distance = std::numeric_limits<float>::infinity();
};

/// Returns the corner that is nearest to the other surface.
NearCorner nearestCorner(const Mesh& mesh, const Bvh& other) {
  NearCorner nearest;
  std::vector<bool> seen(mesh.positions().size());
  for (std::uint32_t i = 0; i < mesh.triangleCount(); ++i)
    for (const std::uint32_t corner : mesh.triangles()[i]) {
      if (seen[corner])
        continue;
      seen[corner] = true;
      const glm::vec3& place = mesh.positions()[corner];
      if (const float away = other.closest(place, 0.0f, nearest.distance).distance;
          away < nearest.distance)
        nearest = {i, place, away};
    }
  return nearest;
}

PointOnMesh nearestOn(const Bvh& tree, const glm::vec3& place) {
  return nearestPointIn(tree.mesh(), tree.closest(place).triangle, place);
}

}  // namespace

std::optional<ShortestWay> shortestWay(const MeshPtr& a, const MeshPtr& b) {
  if (a->triangleCount() == 0 || b->triangleCount() == 0)
    return std::nullopt;
  const BvhPtr treeOfA = treeOf(a);
  const BvhPtr treeOfB = treeOf(b);
  const NearCorner ofA = nearestCorner(*a, *treeOfB);
  const NearCorner ofB = nearestCorner(*b, *treeOfA);
  ShortestWay way;
  way.from = ofA.distance <= ofB.distance ? nearestPointIn(*a, ofA.triangle, ofA.place)
                                          : nearestOn(*treeOfA, ofB.place);
  way.to = nearestOn(*treeOfB, way.from.place);
  constexpr int mostRounds = 1000;
  constexpr float enough = 1e-6f;  // of the distance
  float length = glm::distance(way.from.place, way.to.place);
  for (int round = 0; round < mostRounds && length > 0.0f; ++round) {
    way.from = nearestOn(*treeOfA, way.to.place);
    way.to = nearestOn(*treeOfB, way.from.place);
    const float now = glm::distance(way.from.place, way.to.place);
    if (now >= length * (1.0f - enough))
      break;
    length = now;
  }
  return way;
}

}  // namespace sline::model
