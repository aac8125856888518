// SPDX-License-Identifier: Apache-2.0
#include "model/import/source/polygon.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace sline::model {

namespace {
constexpr std::size_t longestCutLoop = 1024;

using Plane = std::vector<glm::dvec2>;

double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Returns the loop as seen along its Newell normal, counter-clockwise: the axis of the normal's
/// largest component is dropped.
Plane projected(std::span<const std::uint32_t> loop, std::span<const glm::vec3> positions) {
  const glm::dvec3 origin(positions[loop[0]]);
  glm::dvec3 normal(0.0);
  for (std::size_t i = 0; i < loop.size(); ++i)
    normal += glm::cross(glm::dvec3(positions[loop[i]]) - origin,
                         glm::dvec3(positions[loop[(i + 1) % loop.size()]]) - origin);
  const glm::dvec3 size = glm::abs(normal);
  const int drop = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
  const int u = (drop + 1) % 3;
  const int v = (drop + 2) % 3;
  const bool flip = normal[drop] < 0.0;
  Plane plane;
  plane.reserve(loop.size());
  for (const std::uint32_t index : loop) {
    const glm::dvec3 p = glm::dvec3(positions[index]) - origin;
    plane.emplace_back(flip ? -p[u] : p[u], p[v]);
  }
  return plane;
}

bool isConvex(const Plane& plane) {
  const std::size_t n = plane.size();
  for (std::size_t i = 0; i < n; ++i)
    if (!(turn(plane[i], plane[(i + 1) % n], plane[(i + 2) % n]) >= 0.0))
      return false;
  return true;
}

/// Holds the loop that is left while ears are cut off it, as a ring of links.
struct Ring {
  const Plane& plane;
  std::vector<std::uint32_t> before;
  std::vector<std::uint32_t> after;

  explicit Ring(const Plane& corners) : plane(corners) {
    const auto n = std::uint32_t(corners.size());
    for (std::uint32_t i = 0; i < n; ++i) {
      before.push_back((i + n - 1) % n);
      after.push_back((i + 1) % n);
    }
  }

  bool isEar(std::uint32_t i) const {
    const glm::dvec2& a = plane[before[i]];
    const glm::dvec2& b = plane[i];
    const glm::dvec2& c = plane[after[i]];
    if (!(turn(a, b, c) > 0.0))
      return false;
    for (std::uint32_t j = after[after[i]]; j != before[i]; j = after[j]) {
      const glm::dvec2& p = plane[j];
      const bool isCorner = p == a || p == b || p == c;
      if (!isCorner && turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0)
        return false;
    }
    return true;
  }

  void remove(std::uint32_t i) {
    after[before[i]] = after[i];
    before[after[i]] = before[i];
  }
};

void cutEars(std::span<const std::uint32_t> loop, const Plane& plane,
             std::vector<Triangle>& triangles) {
  Ring ring(plane);
  std::uint32_t at = 0;
  std::size_t left = loop.size();
  std::size_t tried = 0;
  while (left > 3) {
    // A loop that crosses itself may have no ear: any corner then goes, so that the loop ends.
    if (ring.isEar(at) || tried >= left) {
      triangles.push_back({loop[ring.before[at]], loop[at], loop[ring.after[at]]});
      ring.remove(at);
      --left;
      tried = 0;
    } else {
      ++tried;
    }
    at = ring.after[at];
  }
  triangles.push_back({loop[ring.before[at]], loop[at], loop[ring.after[at]]});
}
}  // namespace

void cutPolygon(std::span<const std::uint32_t> loop, std::span<const glm::vec3> positions,
                std::vector<Triangle>& triangles) {
  if (loop.size() == 3) {
    triangles.push_back({loop[0], loop[1], loop[2]});
    return;
  }
  if (loop.size() <= longestCutLoop) {
    const Plane plane = projected(loop, positions);
    bool finite = true;
    for (const glm::dvec2& p : plane)
      finite = finite && std::isfinite(p.x) && std::isfinite(p.y);
    if (finite && !isConvex(plane)) {
      cutEars(loop, plane, triangles);
      return;
    }
  }
  for (std::size_t i = 2; i < loop.size(); ++i)
    triangles.push_back({loop[0], loop[i - 1], loop[i]});
}

}  // namespace sline::model
