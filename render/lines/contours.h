// SPDX-License-Identifier: Apache-2.0
// Contours: zero crossings of nv (METHOD §4).
#pragma once

#include "render/lines/cluster_walk.h"

namespace sline::render {

bool contoursMayPass(const model::Cluster& cluster, model::Facing facing);
void extractContours(const ClusterWalk& walk, const LineRequest& request,
                     std::vector<Segment>& segments);

/// Lets contours come by depth, the nearest first; only those count that the surface's own mask
/// surrounds and that nothing of it seems to hide, judged coarsely. Of a surface with an outside
/// only, those that it always hides go.
void rankContours(std::vector<Segment>& contours, const model::Surface& surface,
                  const model::Camera& camera, float t);

}  // namespace sline::render
