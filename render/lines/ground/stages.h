// SPDX-License-Identifier: Apache-2.0
// Tells what the one parameter Γ means to each stage of drawing (S eq. 7–12 as METHOD §7 reads
// them).
#pragma once

#include <algorithm>
#include <cmath>

#include "model/base/units.h"

namespace sline::render {

struct Transitions {
  float contours = 0.0f;    ///< T_C: inner contours enter
  float suggestive = 0.0f;  ///< T_SC: suggestive contours enter
  float hatching = 0.0f;    ///< T_H: hatching enters
  float shading = 0.0f;     ///< T_P: Phong enters
  float complete = 0.0f;    ///< beyond Γ = 4: lines leave while the fill closes
  float lines = 1.0f;       ///< 1 − complete: the share of width and opacity that lines keep
};

/// Re-times T_P (METHOD §7 ▲). As printed, θ_c and the weight let half of the shading in within the
/// last quarter of the stage; ten organs measured with `sline ramp` agree on the power.
inline constexpr float shadingTiming = 0.45f;

/// Returns the transitions at Γ. T_C, T_SC, T_H and T_P stay 1 beyond Γ = 4; `lines` makes the
/// lines leave there.
inline Transitions transitions(Gamma gamma) {
  const auto stage = [g = gamma.value()](float start) { return std::clamp(g - start, 0.0f, 1.0f); };
  return {.contours = stage(0.0f),
          .suggestive = stage(1.0f),
          .hatching = stage(2.0f),
          .shading = std::pow(stage(3.0f), shadingTiming),
          .complete = stage(4.0f),
          .lines = 1.0f - stage(4.0f)};
}

}  // namespace sline::render
