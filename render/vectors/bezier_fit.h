// SPDX-License-Identifier: Apache-2.0
// Few smooth curves for many points: P. J. Schneider, "An Algorithm for Automatically Fitting
// Digitized Curves", Graphics Gems (1990).
#pragma once

#include <span>

#include "render/vectors/path.h"

namespace sline::render {

struct FitOptions {
  float tolerance = 0.25f;  ///< no point lies farther from the curve, in the points' own unit
  /// Where the points turn by more than this within a step, the curve has a corner; radians.
  float corner = 0.9f;
};

/// An open curve from the first point to the last. Of one point, a curve without pieces.
Curve fittedCurve(std::span<const glm::vec2> points, const FitOptions& options);
/// Around once and back to the first point, which need not be repeated; no corners are looked for.
Curve fittedLoop(std::span<const glm::vec2> points, float tolerance);

}  // namespace sline::render
