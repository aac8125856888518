// SPDX-License-Identifier: Apache-2.0
// Finds contours: zero crossings of nv (METHOD §4).
#pragma once

#include "render/lines/ground/cluster_walk.h"
#include "render/lines/techniques/lines.h"

namespace sline::render {

bool contoursMayPass(const model::Cluster& cluster, model::Facing facing,
                     const model::EyePoint& eye);
void extractContours(const ClusterWalk& walk, const LineRequest& request,
                     std::vector<Segment>& segments);

/// Makes contours enter by depth, the nearest first. Only those count that the surface's own mask
/// surrounds and that the surface does not seem to hide, judged coarsely.
void rankContours(std::vector<Segment>& contours, const model::Surface& surface,
                  const model::Camera& camera, float t);

}  // namespace sline::render
