// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "render/vectors/path.h"

namespace sline::test {

/// Returns points along the curve, `steps` to a piece, both ends included.
inline std::vector<glm::vec2> pointsOn(const render::Curve& curve, int steps = 16) {
  std::vector<glm::vec2> points{curve.start};
  glm::vec2 from = curve.start;
  for (const render::Cubic& piece : curve.pieces) {
    for (int i = 1; i <= steps; ++i) {
      const float t = float(i) / float(steps);
      const float s = 1.0f - t;
      points.push_back(s * s * s * from + 3.0f * s * s * t * piece.control1 +
                       3.0f * s * t * t * piece.control2 + t * t * t * piece.end);
    }
    from = piece.end;
  }
  return points;
}

/// Returns the signed area, positive if the curve runs counter-clockwise with y upwards.
inline float areaOf(const render::Curve& curve) {
  const std::vector<glm::vec2> points = pointsOn(curve);
  double twice = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const glm::vec2& a = points[i];
    const glm::vec2& b = points[(i + 1) % points.size()];
    twice += double(a.x) * double(b.y) - double(b.x) * double(a.y);
  }
  return float(0.5 * twice);
}

}  // namespace sline::test
