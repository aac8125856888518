// SPDX-License-Identifier: Apache-2.0
// Knows where a surface lies in the picture and how far it is from the eye, in cells that its
// vertices are sure to fill. This is good enough to guess which part of a line will be seen, and
// far cheaper than rays.
#pragma once

#include <vector>

#include "model/camera/camera.h"
#include "model/geometry/surface.h"
#include "render/lines/ground/view_scale.h"

namespace sline::render {

class CoarseDepth {
 public:
  CoarseDepth(const model::Surface& surface, const model::Camera& camera);
  /// Tells whether no part of the surface lies clearly in front of the point.
  bool sees(const glm::vec3& p) const;
  /// Tells whether the surface continues in the picture beyond a point of a contour, outwards.
  bool surrounds(const glm::vec3& p, const glm::vec3& normal) const;

 private:
  static constexpr float nothing = 1e30f;
  float nearest(const glm::vec2& at) const;
  std::ptrdiff_t cell(const glm::vec2& at) const;

  ViewScale m_scale;
  float m_slack;  ///< mm
  glm::vec2 m_low{0.0f};
  float m_side = 1.0f;  ///< λ
  int m_columns = 1;
  int m_rows = 1;
  std::vector<float> m_nearest;  ///< mm from the eye's plane
};

}  // namespace sline::render
