// SPDX-License-Identifier: Apache-2.0
// Finds demarcating curves: with g the direction in which the normal curvature changes most, they
// are the zeros of ⟨S·g, g⟩, where a valley ends and a ridge begins, where C(g,g,g) is large
// (Kolomenkin, Shimshoni, Tal, "Demarcating curves for shape illustration", SIGGRAPH Asia 2008).
// They do not depend on the view.
#pragma once

#include <array>
#include <memory>

#include "render/lines/techniques/line_technique.h"

namespace sline::render {

enum DemarcatingThreshold : std::size_t { leastDemarcatingChange };
inline constexpr std::array demarcatingThresholds{
    LineThreshold{.id = "change",
                  .meaning = "C(g,g,g)·F² must be above",
                  .usual = 8.0f,
                  .limits = {0.0f, 10000.0f},
                  .grows = true}};

/// Returns the unit vector (cos θ, sin θ) of the principal frame for which C(g,g,g) is greatest,
/// from C's four numbers (see model::Curvature). With t = tan θ its extrema are the roots of
/// −c·t³ + (d − 2b)·t² + (2c − a)·t + b.
glm::vec2 steepestCurvature(const glm::vec4& derivative);

std::unique_ptr<const PreparedLines> prepareDemarcatingCurves(const model::Surface& surface);
void findDemarcatingCurves(const LineSearch& search, std::vector<Segment>& segments);

}  // namespace sline::render
