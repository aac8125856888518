// SPDX-License-Identifier: Apache-2.0
#include "render/lines/cluster_walk.h"

namespace sline::render {

void ClusterWalk::enter(const model::Cluster& cluster) {
  m_cluster = &cluster;
  m_lookedAtAll = false;
  std::fill_n(m_lookedAt.begin(), cluster.vertexCount, false);
}

void ClusterWalk::fetch(const model::Cluster& cluster) const {
  const std::uint32_t* vertices = m_surface.clusters.vertices.data() + cluster.firstVertex;
  for (std::uint32_t i = 0; i < cluster.vertexCount; ++i)
    __builtin_prefetch(&m_surface.vertices[vertices[i]]);
}

void ClusterWalk::lookAtAll() const {
  for (std::uint32_t i = 0; i < m_cluster->vertexCount; ++i)
    lookAt(std::uint8_t(i));
  m_lookedAtAll = true;
}

}  // namespace sline::render
