// SPDX-License-Identifier: Apache-2.0
#include "render/lines/ground/cluster_walk.h"

namespace sline::render {

void ClusterWalk::enter(const model::Cluster& cluster) {
  m_cluster = &cluster;
  m_lookedAtAll = false;
  std::fill_n(m_lookedAt.begin(), cluster.vertexCount, false);
}

void ClusterWalk::lookAtAll() const {
  for (std::uint32_t i = 0; i < m_cluster->vertexCount; ++i)
    fetch(std::uint8_t(i));
  for (std::uint32_t i = 0; i < m_cluster->vertexCount; ++i)
    lookAt(std::uint8_t(i));
  m_lookedAtAll = true;
}

}  // namespace sline::render
