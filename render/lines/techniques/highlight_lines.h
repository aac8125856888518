// SPDX-License-Identifier: Apache-2.0
// Finds suggestive highlights, zeros of κr with Dκr < 0, and principal highlights, where f is
// greatest along the direction of the stronger curvature (DeCarlo and Rusinkiewicz, "Highlight
// lines for conveying shape", NPAR 2007).
#pragma once

#include <array>

#include "render/lines/techniques/line_technique.h"

namespace sline::render {

enum SuggestiveHighlightThreshold : std::size_t { leastDarkening };
inline constexpr std::array suggestiveHighlightThresholds{
    LineThreshold{.id = "t_h",
                  .meaning = "−Dκr·F² must be above",
                  .usual = 8.0f,
                  .limits = {0.0f, 1000.0f},
                  .grows = true}};
enum PrincipalHighlightThreshold : std::size_t { leastHighlightCurvature };
inline constexpr std::array principalHighlightThresholds{
    LineThreshold{.id = "curvature",
                  .meaning = "κ1²·F² must be above",
                  .usual = 16.0f,
                  .limits = {0.0f, 10000.0f},
                  .grows = true}};

void extractSuggestiveHighlights(const ClusterWalk& walk, const LineRequest& request,
                                 std::vector<Segment>& segments);
void extractPrincipalHighlights(const ClusterWalk& walk, const LineRequest& request,
                                std::vector<Segment>& segments);

}  // namespace sline::render
