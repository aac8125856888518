// SPDX-License-Identifier: Apache-2.0
// Finds photic extremum lines: where the headlight's brightness f changes fastest along its
// gradient k, so that Hess f(k,k) falls through zero along k (Xie et al., "An effective
// illustrative visualization framework based on photic extremum lines (PELs)", IEEE VIS 2007).
#pragma once

#include <array>

#include "render/lines/techniques/line_technique.h"

namespace sline::render {

enum PhoticThreshold : std::size_t { leastPhoticSlope };
inline constexpr std::array photicThresholds{LineThreshold{.id = "slope",
                                                           .meaning = "|∇f|·F must be above",
                                                           .usual = 2.0f,
                                                           .limits = {0.0f, 1000.0f},
                                                           .grows = true}};

void extractPhoticExtrema(const ClusterWalk& walk, const LineRequest& request,
                          std::vector<Segment>& segments);

}  // namespace sline::render
