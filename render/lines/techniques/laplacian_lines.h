// SPDX-License-Identifier: Apache-2.0
// Finds Laplacian lines: zeros of Δf of the headlight's brightness f where its gradient is steep
// (Zhang et al., "Real-time computation of photic extremum lines" and "Laplacian lines for
// real-time shape illustration", I3D 2009 and VC 2011). Δf comes from the curvature tensor and its
// derivative, exactly, so no weights of a mesh are needed.
#pragma once

#include <array>

#include "render/lines/techniques/line_technique.h"

namespace sline::render {

enum LaplacianThreshold : std::size_t { leastLaplacianSlope };
inline constexpr std::array laplacianThresholds{LineThreshold{.id = "slope",
                                                              .meaning = "|∇f|·F must be above",
                                                              .usual = 2.0f,
                                                              .limits = {0.0f, 1000.0f},
                                                              .grows = true}};

void extractLaplacianLines(const ClusterWalk& walk, const LineRequest& request,
                           std::vector<Segment>& segments);

}  // namespace sline::render
