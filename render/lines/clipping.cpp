// SPDX-License-Identifier: Apache-2.0
#include "render/lines/clipping.h"

namespace sline::render {

namespace {

glm::vec3 unitOr(const glm::vec3& v, const glm::vec3& other) {
  const float length = glm::length(v);
  return length > 0.0f ? v / length : other;
}

/// Moves end a to t and end b to u along the segment; an end at its own place stays untouched.
Segment part(const Segment& s, double t, double u) {
  const auto at = [](const auto& x, const auto& y, double where) {
    return x + float(where) * (y - x);
  };
  Segment rest = s;
  if (t > 0.0) {
    rest.a = at(s.a, s.b, t);
    rest.normalA = unitOr(at(s.normalA, s.normalB, t), s.normalA);
    rest.opacityA = at(s.opacityA, s.opacityB, t);
  }
  if (u < 1.0) {
    rest.b = at(s.a, s.b, u);
    rest.normalB = unitOr(at(s.normalA, s.normalB, u), s.normalB);
    rest.opacityB = at(s.opacityA, s.opacityB, u);
  }
  return rest;
}

}  // namespace

std::optional<Segment> clipped(const Segment& segment, std::span<const model::Plane> planes) {
  double low = 0.0;
  double high = 1.0;
  for (const model::Plane& plane : planes) {
    const double a = plane.distance(segment.a);
    const double b = plane.distance(segment.b);
    if (a > 0.0 && b > 0.0)
      return std::nullopt;
    if (a > 0.0)
      low = std::max(low, a / (a - b));
    else if (b > 0.0)
      high = std::min(high, a / (a - b));
  }
  if (!(low < high))
    return std::nullopt;
  return part(segment, low, high);
}

void clip(std::vector<Segment>& segments, std::span<const model::Plane> planes) {
  if (planes.empty())
    return;
  std::size_t kept = 0;
  for (const Segment& segment : segments)
    if (const std::optional<Segment> rest = clipped(segment, planes))
      segments[kept++] = *rest;
  segments.resize(kept);
}

}  // namespace sline::render
