// SPDX-License-Identifier: Apache-2.0
// Finds apparent ridges: where the view-dependent curvature q1, the greatest rate at which the
// normal turns as one moves in the picture, is greatest along its own direction (Judd, Durand,
// Adelson, "Apparent ridges for line drawing", SIGGRAPH 2007).
#pragma once

#include <array>
#include <memory>

#include "render/lines/techniques/line_technique.h"

namespace sline::render {

enum ApparentRidgeThreshold : std::size_t { leastApparentCurvature };
inline constexpr std::array apparentRidgeThresholds{LineThreshold{.id = "curvature",
                                                                  .meaning = "q1·F must be above",
                                                                  .usual = 6.3f,
                                                                  .limits = {0.0f, 1000.0f},
                                                                  .grows = true}};

/// Describes the view-dependent curvature at a point, in the principal frame.
struct ApparentCurvature {
  float q1 = 0.0f;        ///< 1/mm in the picture's scale at the point
  glm::vec2 along{0.0f};  ///< the way on the surface that looks 1 mm long, in the direction of q1
};
/// Returns it for principal curvatures k and the tangential part w of the unit view v̂. Q = S·M with
/// M = I + (sec θ − 1)·ŵŵᵀ, which takes a way in the picture to one on the surface; q1² is the
/// greater eigenvalue of QᵀQ. Seen from the side, sec θ is held to 100.
ApparentCurvature apparentCurvature(const glm::vec2& k, const glm::vec2& w, float nv);

void findApparentRidges(const LineSearch& search, std::vector<Segment>& segments);

}  // namespace sline::render
