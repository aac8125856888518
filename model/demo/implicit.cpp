// SPDX-License-Identifier: Apache-2.0
#include "model/demo/implicit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

namespace sline::model {

float ellipsoid(const glm::vec3& p, const glm::vec3& semiAxes) {
  // f/|∇f| of f = |p/a| − 1 in the form that stays finite at the centre.
  const float k0 = glm::length(p / semiAxes);
  const float k1 = glm::length(p / (semiAxes * semiAxes));
  return k1 > 1e-12f ? k0 * (k0 - 1.0f) / k1 : -std::min({semiAxes.x, semiAxes.y, semiAxes.z});
}

namespace {
/// The smaller of both, rounded by a quartic that meets it with continuous curvature.
float smoothMinimum(float a, float b, float radius) {
  const float h = std::max(radius - std::abs(a - b), 0.0f) / radius;
  return std::min(a, b) - h * h * h * (4.0f - h) * radius / 16.0f;
}

struct Knot {
  glm::vec4 value;  ///< position and radius
  float t;
};

/// Barry and Goldman's pyramid for a centripetal Catmull-Rom piece between the two middle knots.
glm::vec4 onCurve(const std::array<Knot, 4>& k, float t) {
  const auto mix = [t](const glm::vec4& a, float ta, const glm::vec4& b, float tb) {
    return a + (t - ta) / (tb - ta) * (b - a);
  };
  const glm::vec4 a1 = mix(k[0].value, k[0].t, k[1].value, k[1].t);
  const glm::vec4 a2 = mix(k[1].value, k[1].t, k[2].value, k[2].t);
  const glm::vec4 a3 = mix(k[2].value, k[2].t, k[3].value, k[3].t);
  const glm::vec4 b1 = mix(a1, k[0].t, a2, k[2].t);
  const glm::vec4 b2 = mix(a2, k[1].t, a3, k[3].t);
  return mix(b1, k[1].t, b2, k[2].t);
}
}  // namespace

float blendedUnion(float a, float b, float radius) {
  return smoothMinimum(a, b, radius);
}

float blendedDifference(float a, float b, float radius) {
  return -smoothMinimum(-a, b, radius);
}

Tube::Tube(std::span<const TubePoint> through, float step) {
  std::vector<Knot> knots;
  const auto add = [&knots](const glm::vec4& value) {
    const float t = knots.empty()
                        ? 0.0f
                        : knots.back().t + std::sqrt(glm::distance(glm::vec3(knots.back().value),
                                                                   glm::vec3(value)));
    knots.push_back({value, t});
  };
  const auto value = [](const TubePoint& p) { return glm::vec4(p.position, p.radius); };
  // Phantom ends continue the first and last piece straight on.
  const std::size_t last = through.size() - 1;
  add(2.0f * value(through[0]) - value(through[1]));
  for (const TubePoint& p : through)
    add(value(p));
  add(2.0f * value(through[last]) - value(through[last - 1]));
  for (std::size_t i = 0; i < last; ++i) {
    const std::array<Knot, 4> piece{knots[i], knots[i + 1], knots[i + 2], knots[i + 3]};
    const float length = glm::distance(through[i].position, through[i + 1].position);
    const int steps = std::max(2, int(std::ceil(length / step)));
    for (int s = 0; s < steps + (i + 1 == last); ++s) {
      const float t = piece[1].t + (piece[2].t - piece[1].t) * float(s) / float(steps);
      const glm::vec4 p = onCurve(piece, t);
      m_points.push_back({glm::vec3(p), std::max(p.w, 0.1f)});
    }
  }
  for (const TubePoint& p : m_points) {
    m_bounds.add(p.position - p.radius);
    m_bounds.add(p.position + p.radius);
  }
}

float Tube::distance(const glm::vec3& p) const {
  // Far away the box's distance, a lower bound, is as good: no blend reaches that far.
  constexpr float farAway = 12.0f;
  const glm::vec3 outside =
      glm::max(glm::max(m_bounds.low - p, p - m_bounds.high), glm::vec3(0.0f));
  const float toBox = glm::length(outside);
  if (toBox > farAway)
    return toBox;
  float best = std::numeric_limits<float>::infinity();
  for (std::size_t i = 0; i + 1 < m_points.size(); ++i) {
    const glm::vec3 axis = m_points[i + 1].position - m_points[i].position;
    const glm::vec3 d = p - m_points[i].position;
    const float t = std::clamp(glm::dot(d, axis) / glm::dot(axis, axis), 0.0f, 1.0f);
    const float radius = m_points[i].radius + t * (m_points[i + 1].radius - m_points[i].radius);
    best = std::min(best, glm::length(d - t * axis) - radius);
  }
  return best;
}

}  // namespace sline::model
