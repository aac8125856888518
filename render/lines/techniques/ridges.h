// SPDX-License-Identifier: Apache-2.0
// Finds ridges and valleys: where the stronger curvature κ1 is greatest, or least, along its own
// direction, from the exact derivative C(e1,e1,e1) at vertices (Ohtake et al., "Ridge-valley lines
// on meshes via implicit surface fitting", SIGGRAPH 2004). They do not depend on the view.
//
// ▲ A surface whose curvature hardly changes along its lines, such as a torus, has extrema by noise
// alone; so κ1 must also fall away beside the line, by |κ1''|/|κ1|³, which has no dimension.
#pragma once

#include <array>
#include <memory>

#include "render/lines/techniques/line_technique.h"

namespace sline::render {

enum RidgeThreshold : std::size_t { leastRidgeCurvature, leastRidgeSharpness };
inline constexpr std::array ridgeThresholds{
    LineThreshold{.id = "curvature",
                  .meaning = "|κ1|·F must be above",
                  .usual = 2.0f,
                  .limits = {0.0f, 1000.0f},
                  .grows = true},
    LineThreshold{.id = "sharpness",
                  .meaning = "|κ1''|/|κ1|³ across the line must be above",
                  .usual = 0.05f,
                  .limits = {0.0f, 100.0f}}};

std::unique_ptr<const PreparedLines> prepareRidges(const model::Surface& surface);
std::unique_ptr<const PreparedLines> prepareValleys(const model::Surface& surface);
void findRidges(const LineSearch& search, std::vector<Segment>& segments);
void findValleys(const LineSearch& search, std::vector<Segment>& segments);

}  // namespace sline::render
