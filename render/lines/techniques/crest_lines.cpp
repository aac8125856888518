// SPDX-License-Identifier: Apache-2.0
#include "render/lines/techniques/crest_lines.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

namespace sline::render {

namespace {

/// Tells whether the corners' axes belong together.
bool agree(const std::array<CrestCorner, 3>& corners) {
  constexpr float halfRightAngle = 0.70710678f;
  for (std::size_t i = 0; i < 3; ++i)
    if (std::abs(glm::dot(corners[i].axis, corners[(i + 1) % 3].axis)) < halfRightAngle)
      return false;
  return true;
}

LineEnd mixed(const CrestCorner& a, const CrestCorner& b, float share) {
  const auto mix = [share](const auto& x, const auto& y) { return x + share * (y - x); };
  return {.position = mix(a.position, b.position),
          .normal = mix(a.normal, b.normal),
          .nv = mix(a.nv, b.nv),
          .strength = mix(a.strength, b.strength)};
}

/// Returns where on the edge the value stops rising, if it does so between the corners.
std::optional<LineEnd> crossing(const CrestCorner& a, const CrestCorner& b) {
  if (!(glm::dot(a.rise, b.rise) < 0.0f))
    return std::nullopt;
  // Both triangles at the edge get exactly the same point.
  if (std::lexicographical_compare(&b.position.x, &b.position.x + 3, &a.position.x,
                                   &a.position.x + 3))
    return crossing(b, a);
  const float riseA = glm::length(a.rise);
  const float riseB = glm::length(b.rise);
  return mixed(a, b, riseA / (riseA + riseB));
}

/// Tells whether the value rises from the corner towards the line.
bool risesTo(const CrestCorner& corner, const std::array<LineEnd, 2>& line) {
  const glm::vec3 along = line[1].position - line[0].position;
  const float length2 = glm::dot(along, along);
  glm::vec3 way = line[0].position - corner.position;
  if (length2 > 0.0f)
    way -= glm::dot(way, along) / length2 * along;
  return glm::dot(corner.rise, way) > 0.0f;
}

}  // namespace

std::vector<std::array<LineEnd, 2>> crestsIn(const CrestTriangle& triangle) {
  const std::array<CrestCorner, 3>& c = triangle.corners;
  if (!agree(c))
    return {};
  std::array<std::optional<LineEnd>, 3> on;  // of the edge from each corner to the next
  std::size_t count = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    on[i] = crossing(c[i], c[(i + 1) % 3]);
    count += on[i] ? 1 : 0;
  }
  if (count == 2) {
    const std::size_t free = !on[0] ? 0 : !on[1] ? 1 : 2;
    const std::size_t alone = (free + 2) % 3;  // the corner that both edges have
    const std::array<LineEnd, 2> line{*on[alone], *on[(free + 1) % 3]};
    const bool greatest =
        risesTo(c[alone], line) && (risesTo(c[free], line) || risesTo(c[(free + 1) % 3], line));
    return greatest ? std::vector{line} : std::vector<std::array<LineEnd, 2>>();
  }
  if (count < 3)
    return {};
  LineEnd middle;
  for (const CrestCorner& corner : c) {
    middle.position += corner.position / 3.0f;
    middle.normal += corner.normal / 3.0f;
    middle.nv += corner.nv / 3.0f;
    middle.strength += corner.strength / 3.0f;
  }
  for (const CrestCorner& corner : c)
    if (!(glm::dot(corner.rise, middle.position - corner.position) > 0.0f))
      return {};
  return {{*on[0], middle}, {*on[1], middle}, {*on[2], middle}};
}

void appendCrests(const CrestTriangle& triangle, const LineClip& clip,
                  std::vector<Segment>& segments) {
  for (const std::array<LineEnd, 2>& line : crestsIn(triangle))
    appendClipped(line, clip, triangle.triangle, segments);
}

}  // namespace sline::render
