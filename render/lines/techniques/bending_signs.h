// SPDX-License-Identifier: Apache-2.0
// Finds the sign of the radial curvature at a cluster's vertices, nearly always from the bounds and
// samples that the cluster keeps. What these leave open is computed
// from the mesh: the signs are those of `ClusterWalk::bendingAt` without exception.
#pragma once

#include "render/lines/ground/cluster_walk.h"

namespace sline::render {

/// Returns whether κr may have both signs in the cluster, as far as its bounds alone tell.
bool mayBendBothWays(const model::Cluster& cluster, const model::EyePoint& eye);

class BendingSigns {
 public:
  /// Looks at the cluster's candidate vertices; returns whether they have both signs.
  bool find(const ClusterWalk& walk);

  /// Lists the candidate triangles with a corner of another sign than the two others.
  std::span<const Signs::Crossed> crossed(const ClusterWalk& walk) {
    return m_signs.crossed(walk.locals(walk.cluster().candidateTriangles));
  }

 private:
  /// Sets κr·|w|² as the samples tell it; returns by how much it may be wrong.
  float estimate(const ClusterWalk& walk);

  ClusterWalk::Field m_bending;
  Signs m_signs;
};

}  // namespace sline::render
