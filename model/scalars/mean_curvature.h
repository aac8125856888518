// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "model/geometry/surface.h"

namespace sline::model {

/// Returns H·F per vertex, the mean curvature times the feature size (METHOD §1): without a unit, 1
/// on a sphere, positive where the surface is convex and negative in hollows. What is smaller than
/// a fiftieth of F is averaged out, as estimates at single vertices are noise. Vertices without
/// faces have 0.
std::vector<float> meanCurvature(const Surface& surface);

}  // namespace sline::model
