// SPDX-License-Identifier: Apache-2.0
// Finds suggestive contours: zero crossings of κr with Dκr·F² > t_d and acos(nv) > θ_c (METHOD §5,
// DeCarlo et al. 2003).
#pragma once

#include <array>

#include "model/base/units.h"
#include "render/lines/techniques/line_technique.h"

namespace sline::render {

inline constexpr float defaultMinimumDerivative = 1.0f;  ///< t_dmin
inline constexpr float defaultMinimumAngle = 0.05f;      ///< θ_cmin

enum SuggestiveThreshold : std::size_t { leastDerivative, leastAngle };
inline constexpr std::array suggestiveThresholds{
    LineThreshold{.id = "t_d",
                  .meaning = "Dκr·F² must be above",
                  .usual = defaultMinimumDerivative,
                  .limits = {0.0f, 1000.0f},
                  .grows = true},
    LineThreshold{.id = "theta_c",
                  .meaning = "acos(nv) must be above, radians",
                  .usual = defaultMinimumAngle,
                  .limits = {0.0f, 1.57079633f}}};
/// Sets the thresholds that T_SC of METHOD §7 gives at Γ (S eq. 9).
void setSuggestiveThresholds(Gamma gamma, LineThresholds& thresholds);

bool suggestiveContoursMayPass(const model::Cluster& cluster, model::Facing facing,
                               const model::EyePoint& eye);
void extractSuggestiveContours(const ClusterWalk& walk, const LineRequest& request,
                               std::vector<Segment>& segments);

/// Makes the segments enter in the order in which the thresholds of S eq. 9 admit them.
void rankSuggestiveContours(std::vector<Segment>& segments, const model::Surface& surface,
                            const model::Camera& camera, float t);

}  // namespace sline::render
