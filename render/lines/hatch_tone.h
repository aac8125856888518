// SPDX-License-Identifier: Apache-2.0
// Computes how dark hatching is and where it runs, at every vertex of a surface (METHOD §6.6).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "model/geometry/surface.h"

namespace sline::render {

/// Describes from where hatching is seen and lit.
struct HatchView {
  model::EyePoint eye;
  glm::vec3 light{0.0f};  ///< unit, towards the light
  bool twoSided = false;  ///< see LineRequest
  float tone = 1.0f;      ///< of hatching; much of it lets shadows reach farther into the light
};

/// Holds what hatching needs at a vertex, all on the side that faces the eye.
struct HatchField {
  float weight = 0.0f;  ///< of a hollow, w_k·F_c = −⟨k, v̂⟩·F_c (S eq. 6), or of the form's shadow
  float angle = 2.0f;  ///< acos(nv) / (π/2): 0 facing the eye, 1 on the contour, more behind it
};

/// Holds one entry for each of Clusters::vertices; only clusters that may carry hatching are looked
/// at.
///
/// ▲ w_k is positive in hollows alone: on a liver seen from the front S draws nothing, and Γ = 3
/// looks like Γ = 2. A form therefore has a shadow of its own too, on the side away from the light,
/// as everything in an atlas has; w_a (S eq. 6) lets it grow towards the contour. Hatching far
/// darker than usual has not only broader strokes: as in a woodcut, all but the lights is in
/// shadow.
class HatchFields {
 public:
  HatchFields(const model::Surface& surface, const HatchView& view);
  /// Tells whether any vertex of the cluster faces the eye; the others have no fields.
  bool facesEye(std::uint32_t cluster) const { return m_front[cluster] != 0; }
  HatchField operator[](std::size_t vertex) const { return {m_weight[vertex], m_angle[vertex]}; }
  /// Returns the clusters that have a vertex of positive weight, ascending.
  const std::vector<std::uint32_t>& clusters() const { return m_clusters; }

 private:
  // Not initialised, as in most views half of the clusters need none.
  std::unique_ptr<float[]> m_weight;
  std::unique_ptr<float[]> m_angle;
  std::vector<std::uint8_t> m_front;  ///< by cluster
  std::vector<std::uint32_t> m_clusters;
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
