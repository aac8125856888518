// SPDX-License-Identifier: Apache-2.0
// Shapes as signed distances: negative inside, positive outside, in millimetres (near the surface;
// far away only the sign is exact). Anatomy is built by blending a few of them.
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "model/geometry/mesh.h"

namespace sline::model {

using Field = std::function<float(const glm::vec3&)>;

/// About the signed distance to an ellipsoid at the origin, exact to first order at its surface.
float ellipsoid(const glm::vec3& p, const glm::vec3& semiAxes);

/// Union and difference whose seam is rounded over about `radius` mm, with continuous curvature.
float blendedUnion(float a, float b, float radius);
float blendedDifference(float a, float b, float radius);

/// A place on a vessel's centre line.
struct TubePoint {
  glm::vec3 position;
  float radius;
};

/// A tube with a round cross-section along a smooth curve through the given points (centripetal
/// Catmull and Rom, sampled every `step` mm), its radius changing smoothly between them, its ends
/// rounded.
class Tube {
 public:
  explicit Tube(std::span<const TubePoint> through, float step = 1.5f);
  float distance(const glm::vec3& p) const;
  const Box& bounds() const { return m_bounds; }
  const std::vector<TubePoint>& points() const { return m_points; }

 private:
  std::vector<TubePoint> m_points;
  Box m_bounds;
};

}  // namespace sline::model
