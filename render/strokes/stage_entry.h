// SPDX-License-Identifier: Apache-2.0
// When each part of a line enters its stage (METHOD §7 ▲): lines come by length as well as by
// width, and the drawn length grows evenly with T.
#pragma once

#include <vector>

#include "render/lines/lines.h"

namespace sline::render {

/// Replaces the segments' entries by their rank, so that of all length as much enters before any
/// time as that time says. Contours come by depth, the nearest first; only those count that the
/// surface's own mask surrounds and that nothing of it seems to hide, judged coarsely.
void rankContours(std::vector<Segment>& contours, const model::Surface& surface,
                  const model::Camera& camera);
/// Suggestive contours come in the order in which the thresholds of S eq. 9 let them in.
void rankSuggestive(std::vector<Segment>& suggestive);

/// How far a line of that rank has entered at T, 0 … 1; the mean over all ranks is T.
float entered(float t, float rank);

}  // namespace sline::render
