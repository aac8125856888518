// SPDX-License-Identifier: Apache-2.0
#include "render/lines/cluster_walk.h"

namespace sline::render {

// The straight loops over arrays become vector instructions in the compiler.
void ClusterWalk::enter(const model::Cluster& cluster) {
  m_cluster = &cluster;
  const model::ClusterVertices& in = m_surface.clusters.fields;
  const std::size_t first = cluster.firstVertex;
  const std::size_t count = cluster.vertexCount;
  const float* px = in.position[0].data() + first;
  const float* py = in.position[1].data() + first;
  const float* pz = in.position[2].data() + first;
  const float* nx = in.normal[0].data() + first;
  const float* ny = in.normal[1].data() + first;
  const float* nz = in.normal[2].data() + first;
  std::array<const float*, 6> s{};
  for (std::size_t i = 0; i < 6; ++i)
    s[i] = in.s[i].data() + first;
  // In a parallel projection d is the eye's direction itself.
  const float scale = m_eye.atInfinity ? 0.0f : 1.0f;
  for (std::size_t i = 0; i < count; ++i) {
    const float x = m_eye.value.x - scale * px[i];
    const float y = m_eye.value.y - scale * py[i];
    const float z = m_eye.value.z - scale * pz[i];
    m_distanceSquared[i] = x * x + y * y + z * z;
    m_facing[i] = nx[i] * x + ny[i] * y + nz[i] * z;
    m_bending[i] = x * (s[0][i] * x + 2.0f * (s[1][i] * y + s[2][i] * z)) +
                   y * (s[3][i] * y + 2.0f * s[4][i] * z) + s[5][i] * z * z;
  }
}

}  // namespace sline::render
