// SPDX-License-Identifier: Apache-2.0
// Finds suggestive contours: zero crossings of κr with Dκr·F² > t_d and acos(nv) > θ_c (METHOD §5,
// DeCarlo et al. 2003).
#pragma once

#include "model/base/units.h"
#include "render/lines/line_technique.h"

namespace sline::render {

inline constexpr float defaultMinimumDerivative = 1.0f;  ///< t_dmin
inline constexpr float defaultMinimumAngle = 0.05f;      ///< θ_cmin

/// Returns the thresholds that T_SC of METHOD §7 gives at Γ (S eq. 9).
LineThresholds suggestiveThresholds(Gamma gamma);
/// Returns these thresholds as `sline lines` writes them.
LineFigures suggestiveFigures(Gamma gamma);

bool suggestiveContoursMayPass(const model::Cluster& cluster, model::Facing facing);
void extractSuggestiveContours(const ClusterWalk& walk, const LineRequest& request,
                               std::vector<Segment>& segments);

/// Makes the segments enter in the order in which the thresholds of S eq. 9 admit them.
void rankSuggestiveContours(std::vector<Segment>& segments, const model::Surface& surface,
                            const model::Camera& camera, float t);

}  // namespace sline::render
