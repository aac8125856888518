// SPDX-License-Identifier: Apache-2.0
// Makes surfaces ready to be drawn on the processor, and finds where their clusters lie.
#pragma once

#include <cstdint>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "render/software/surface_raster.h"
#include "render/software/surface_values.h"

namespace sline::render {

/// A member, ready to be drawn.
struct ReadyMember {
  const DrawnStructure* shown;
  const model::Clusters* clusters;
  SampleShading shading;
  bool cull;
  std::vector<glm::vec4> planes;  ///< sections: (normal, −offset), > 0 where they take away

  ReadyMember(const RasterMember& member, const RasterSight& sight);
};

/// A cluster of a member's, with the rows of samples that it may touch, the last one not included.
struct PlacedCluster {
  const model::Cluster* cluster;
  std::uint16_t member;
  int bottom, top;
};

/// Returns the clusters that may be seen, in the members' order.
std::vector<PlacedCluster> placedClusters(std::span<const ReadyMember> members,
                                          const RasterSight& sight);

}  // namespace sline::render
