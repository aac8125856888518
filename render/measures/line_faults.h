// SPDX-License-Identifier: Apache-2.0
// Measures how far a pen's curves lie from the lines that they stand for (METHOD §11.2), and
// whether thin structures keep their width.
#pragma once

#include <vector>

#include "render/measures/ink_frames.h"

namespace sline::render {

/// No silhouette of a thin structure may be narrower than it is by more than this share.
inline constexpr double narrowLimit = 0.03;
/// Structures are thin where their outline is nearer than this, λ, on the other side.
inline constexpr float thinWidth = 12.0f;

struct CurveFaults {
  /// For each kind: the distance of each point of its curves from the nearest exact line, λ,
  /// unsorted.
  std::array<std::vector<float>, lineKindCount> distances;
  /// Sums over pairs of opposite points of thin outlines, λ: exact and as drawn.
  double exactWidth = 0.0;
  double drawnWidth = 0.0;

  double narrowing() const { return exactWidth > 0.0 ? 1.0 - drawnWidth / exactWidth : 0.0; }
};

/// Adds what one structure's lines and curves show in a view.
void addFaults(const PictureView& view, const LineSet& exact, const LineSet& curves,
               CurveFaults& faults);

/// Returns the value that this share of the values does not exceed; 0 where there are none.
float percentile(std::vector<float> values, double share);

}  // namespace sline::render
