// SPDX-License-Identifier: Apache-2.0
// Tells what section planes take away of a cluster that they may go through.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "render/software/seen_cluster.h"

namespace sline::render {

class ClusterCuts {
 public:
  /// Finds which of the planes, (normal, −offset) and above zero where they take away, may go
  /// through the cluster.
  void find(const model::Cluster& cluster, std::span<const glm::vec4> planes);
  bool empty() const { return m_planes.empty(); }
  /// Finds how far the cluster's vertices lie beyond them.
  void measure(const model::Cluster& cluster, const ClusterPlaces& places);
  /// Tells whether they take away the place of a triangle, named by the vertices in its corners,
  /// that has these shares of the second corner and the third.
  bool takeAway(const std::array<std::uint8_t, 3>& corners, const glm::vec2& share) const;

 private:
  std::vector<glm::vec4> m_planes;
  std::vector<SeenCluster::Vertices> m_distances;  ///< of one plane after the other
};

}  // namespace sline::render
