// SPDX-License-Identifier: Apache-2.0
#include "render/strokes/line_joints.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace sline::render {

namespace {

// By how much opacity and entry between a piece's ends may differ from the straight way between
// theirs.
constexpr float opacityError = 0.03f;

constexpr std::size_t numbers = 8;
static_assert(sizeof(JointPoint) == numbers * sizeof(float));

/// Holds what lies between two points of a curve against the straight piece between them.
class Piece {
 public:
  Piece(const JointPoint& a, const JointPoint& b, const JointLimits& limits)
      : m_a(std::bit_cast<Numbers>(a)),
        m_limits(limits),
        m_start(a.drawn),
        m_way(b.drawn - a.drawn),
        m_perLength2(1.0f / std::max(glm::dot(m_way, m_way), 1e-12f)) {
    const auto end = std::bit_cast<Numbers>(b);
    for (std::size_t i = 0; i < numbers; ++i)
      m_change[i] = end[i] - m_a[i];
  }

  bool standsFor(const JointPoint& p) const {
    const float t = std::clamp(glm::dot(p.drawn - m_start, m_way) * m_perLength2, 0.0f, 1.0f);
    // All numbers of the point at once: how far they are from what the piece says there.
    const auto own = std::bit_cast<Numbers>(p);
    Numbers off;
    for (std::size_t i = 0; i < numbers; ++i)
      off[i] = std::abs(own[i] - (m_a[i] + t * m_change[i]));
    const auto [drawnX, drawnY, lineX, lineY, depth, width, opacity, entry] = off;
    return (drawnX * drawnX + drawnY * drawnY <= m_limits.drawn * m_limits.drawn) &
           (lineX * lineX + lineY * lineY <= m_limits.line * m_limits.line) &
           (depth <= m_limits.depth) & (width <= m_limits.drawn) & (opacity <= opacityError) &
           (entry <= opacityError);
  }

 private:
  using Numbers = std::array<float, numbers>;

  Numbers m_a;
  Numbers m_change;
  const JointLimits& m_limits;
  glm::vec2 m_start;
  glm::vec2 m_way;
  float m_perLength2;
};

}  // namespace

std::size_t farthestJoint(std::span<const JointPoint> points, std::size_t from,
                          const JointLimits& limits) {
  std::size_t to = from + 1;
  for (std::size_t end = from + 2; end < points.size(); ++end) {
    if (glm::distance(points[from].drawn, points[end].drawn) > limits.longest)
      break;
    const Piece piece(points[from], points[end], limits);
    const auto between = points.subspan(from + 1, end - from - 1);
    if (!std::all_of(between.begin(), between.end(),
                     [&](const JointPoint& p) { return piece.standsFor(p); }))
      break;
    to = end;
  }
  return to;
}

}  // namespace sline::render
