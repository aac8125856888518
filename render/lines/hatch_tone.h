// SPDX-License-Identifier: Apache-2.0
// How dark hatching is and where it runs, at every vertex of a surface (METHOD §6.6).
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <vector>

#include "model/geometry/surface.h"
#include "render/lines/hatching.h"

namespace sline::render {

/// What hatching is made of at a vertex; all on the side that faces the eye.
struct HatchField {
  glm::vec3 k{0.0f};    ///< light gradient, 1/mm
  float weight = 0.0f;  ///< w_k·F_c = −⟨k, v̂⟩·F_c: positive on concave parts
  float angle = 2.0f;   ///< acos(nv) / (π/2): 0 facing the eye, 1 on the contour, more behind it
};

/// One entry per vertex; only clusters that may carry hatching are looked at.
class HatchFields {
 public:
  HatchFields(const model::Surface& surface, const model::EyePoint& eye, bool twoSided);
  const HatchField& operator[](std::uint32_t vertex) const { return m_fields[vertex]; }
  /// Clusters with a vertex of positive weight, ascending.
  const std::vector<std::uint32_t>& clusters() const { return m_clusters; }

 private:
  std::vector<HatchField> m_fields;
  std::vector<std::uint32_t> m_clusters;
};

/// O_h (S eq. 6, 10), 0 … 1, while θ_c = (π/2)(1 − entered).
inline float hatchOpacity(float weight, float angle, float entered) {
  if (!(entered > 0.0f) || angle >= 1.0f)
    return 0.0f;
  const float byAngle = std::clamp((angle - (1.0f - entered)) / entered, 0.0f, 1.0f);
  return std::clamp(byAngle * weight, 0.0f, 1.0f);
}

/// W = 0.62·O_h^0.6: the share of the space between strokes that ink takes (METHOD §6.6 ▲). The
/// power is interpolated in a table over √O_h, within 10⁻³: it is most of the work otherwise.
float hatchWidth(float opacity);

}  // namespace sline::render
