// SPDX-License-Identifier: Apache-2.0
#include "render/software/cluster_cuts.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace sline::render {

void ClusterCuts::find(const model::Cluster& cluster, std::span<const glm::vec4> planes) {
  m_planes.clear();
  for (const glm::vec4& plane : planes)
    if (glm::dot(plane, glm::vec4(cluster.bounds.centre, 1.0f)) > -1.01f * cluster.bounds.radius)
      m_planes.push_back(plane);
}

void ClusterCuts::measure(const model::Cluster& cluster, const ClusterPlaces& places) {
  const std::uint32_t* vertices = places.clusters.vertices.data() + cluster.firstVertex;
  m_distances.resize(m_planes.size());
  for (std::size_t k = 0; k < m_planes.size(); ++k)
    for (std::uint32_t i = 0; i < cluster.vertexCount; ++i)
      m_distances[k][i] = glm::dot(m_planes[k], glm::vec4(places.positions[vertices[i]], 1.0f));
}

bool ClusterCuts::takeAway(const std::array<std::uint8_t, 3>& corners,
                           const glm::vec2& share) const {
  return std::any_of(
      m_distances.begin(), m_distances.end(), [&](const SeenCluster::Vertices& distance) {
        const float a = distance[corners[0]];
        return a + share.x * (distance[corners[1]] - a) + share.y * (distance[corners[2]] - a) >
               0.0f;
      });
}

}  // namespace sline::render
