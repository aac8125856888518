// SPDX-License-Identifier: Apache-2.0
// Fits a few smooth curves to many points, after P. J. Schneider, "An Algorithm for Automatically
// Fitting Digitized Curves", Graphics Gems (1990).
#pragma once

#include <span>

#include "render/vectors/path.h"

namespace sline::render {

struct FitOptions {
  float tolerance = 0.25f;  ///< no point lies farther from the curve, in the points' own unit
  /// The curve has a corner where the points turn by more than this within a step; radians.
  float corner = 0.9f;
};

/// Returns an open curve from the first point to the last; for a single point, a curve without
/// pieces.
Curve fittedCurve(std::span<const glm::vec2> points, const FitOptions& options);
/// Returns a curve around all points and back to the first, which need not be repeated. It has no
/// corners.
Curve fittedLoop(std::span<const glm::vec2> points, float tolerance);

}  // namespace sline::render
