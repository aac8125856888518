// SPDX-License-Identifier: Apache-2.0
// Finds where the mean curvature has an extremum, as ConFIS does (METHOD §8).
#pragma once

#include <vector>

#include "model/geometry/surface.h"

namespace sline::render {

/// Returns for every triangle |H|·F_c, the mean curvature's magnitude at its middle, where H has an
/// extremum within it, and 0 elsewhere. With a gradient of H at each corner, it has one if at least
/// two of the three products of two gradients are negative: two on a ridge or in a valley, and
/// perhaps all three at a top.
std::vector<float> meanCurvatureFeatures(const model::Surface& surface);

}  // namespace sline::render
