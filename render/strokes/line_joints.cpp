// SPDX-License-Identifier: Apache-2.0
#include "render/strokes/line_joints.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace sline::render {

namespace {

// By how much opacity and entry between a piece's ends may differ from the straight way between
// theirs.
constexpr float opacityError = 0.03f;

/// Holds what lies between two points of a curve against the straight piece between them.
class Piece {
 public:
  Piece(const JointPoint& a, const JointPoint& b, const JointLimits& limits)
      : m_a(a), m_b(b), m_limits(limits), m_way(b.drawn - a.drawn) {
    m_perLength2 = 1.0f / std::max(glm::dot(m_way, m_way), 1e-12f);
  }

  bool standsFor(const JointPoint& p) const {
    const glm::vec2 from = p.drawn - m_a.drawn;
    const float t = std::clamp(glm::dot(from, m_way) * m_perLength2, 0.0f, 1.0f);
    return within(from - t * m_way, m_limits.drawn) &&
           within(p.line - glm::mix(m_a.line, m_b.line, t), m_limits.line) &&
           std::abs(p.depth - glm::mix(m_a.depth, m_b.depth, t)) <= m_limits.depth &&
           std::abs(p.width - glm::mix(m_a.width, m_b.width, t)) <= m_limits.drawn &&
           std::abs(p.opacity - glm::mix(m_a.opacity, m_b.opacity, t)) <= opacityError &&
           std::abs(p.entry - glm::mix(m_a.entry, m_b.entry, t)) <= opacityError;
  }

 private:
  static bool within(const glm::vec2& off, float limit) {
    return glm::dot(off, off) <= limit * limit;
  }

  const JointPoint& m_a;
  const JointPoint& m_b;
  const JointLimits& m_limits;
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
