// SPDX-License-Identifier: Apache-2.0
// Finds the signs of nv at a cluster's vertices without looking at the mesh, from the samples that
// the cluster keeps. What these leave open is computed from the mesh, so that no sign is wrong.
#pragma once

#include "render/lines/ground/cluster_walk.h"

namespace sline::render {

class FacingSigns {
 public:
  /// Looks at the cluster's vertices; returns whether they have both signs.
  bool find(const ClusterWalk& walk);

  /// Lists the triangles with a corner of another sign than the two others.
  std::span<const Signs::Crossed> crossed(const ClusterWalk& walk) {
    return m_signs.crossed(walk.locals(walk.cluster().triangleCount));
  }

 private:
  ClusterWalk::Field m_facing;
  Signs m_signs;
};

}  // namespace sline::render
