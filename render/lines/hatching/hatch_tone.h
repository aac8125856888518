// SPDX-License-Identifier: Apache-2.0
// Computes how dark hatching is along strokes that lie on a surface (METHOD §6.6).
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <vector>

#include "model/geometry/surface.h"
#include "render/lines/hatching/stroke_layout.h"

namespace sline::render {

/// Describes from where hatching is seen and lit.
struct HatchView {
  model::EyePoint eye;
  glm::vec3 light{0.0f};      ///< unit, towards the light
  bool twoSided = false;      ///< see LineRequest
  float tone = 1.0f;          ///< of hatching; much of it lets shadows reach farther into the light
  float filigreeSize = 0.0f;  ///< F_c, mm
  float bare =
      0.0f;  ///< an opacity O_h up to which nothing is drawn where all hatching has entered
};

/// Holds what hatching needs at each point of a stroke, all on the side that faces the eye, in rows
/// as long as the tile's.
///
/// ▲ w_k is positive in hollows alone: on a liver seen from the front S draws nothing, and Γ = 3
/// looks like Γ = 2. A form therefore has a shadow of its own too, on the side away from the light,
/// as everything in an atlas has; w_a (S eq. 6) lets it grow towards the contour. Hatching far
/// darker than usual has not only broader strokes: as in a woodcut, all but the lights is in
/// shadow.
struct HatchTone {
  /// Of a hollow, w_k·F_c = −⟨k, v̂⟩·F_c (S eq. 6), or of the form's shadow.
  std::vector<float> weight;
  /// acos(nv) / (π/2): 0 facing the eye, 1 on the contour, more behind it.
  std::vector<float> angle;
  std::vector<float> facing;  ///< nv

  /// Computes them for a stroke of the tile; returns whether any point may be drawn.
  bool find(const LaidTile& tile, const LaidStroke& stroke, const HatchView& view);
};

/// Returns O_h (S eq. 6, 10), 0 … 1, with θ_c = (π/2)(1 − entered).
inline float hatchOpacity(float weight, float angle, float entered) {
  if (!(entered > 0.0f) || angle >= 1.0f)
    return 0.0f;
  const float byAngle = std::clamp((angle - (1.0f - entered)) / entered, 0.0f, 1.0f);
  return std::clamp(byAngle * weight, 0.0f, 1.0f);
}

/// Returns W = 0.62·O_h^0.6, the share of the space between strokes that ink takes (METHOD §6.6 ▲).
/// The power is interpolated in a table over √O_h, within 10⁻³, as it would otherwise be most of
/// the work.
float hatchWidth(float opacity);

}  // namespace sline::render
