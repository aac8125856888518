// SPDX-License-Identifier: Apache-2.0
#include "model/demo/sheet.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

namespace sline::model {

namespace {
/// Uniform Catmull-Rom weights of the four knots around a piece, t from 0 to 1 along it.
std::array<float, 4> weights(float t) {
  const float t2 = t * t;
  const float t3 = t2 * t;
  return {0.5f * (-t3 + 2.0f * t2 - t), 0.5f * (3.0f * t3 - 5.0f * t2 + 2.0f),
          0.5f * (-3.0f * t3 + 4.0f * t2 + t), 0.5f * (t3 - t2)};
}

/// A row or column of knots read at `at` (0 at the first); beyond its ends it runs straight on.
template <class Knot>
glm::vec4 along(const Knot& knot, int count, float at) {
  const int piece = std::clamp(int(at), 0, count - 2);
  const auto extended = [&](int i) {
    if (i < 0)
      return 2.0f * knot(0) - knot(1);
    return i < count ? knot(i) : 2.0f * knot(count - 1) - knot(count - 2);
  };
  const std::array<float, 4> w = weights(at - float(piece));
  return w[0] * extended(piece - 1) + w[1] * extended(piece) + w[2] * extended(piece + 1) +
         w[3] * extended(piece + 2);
}

/// Closest point of a triangle as weights of its corners b and c (Ericson, Real-Time Collision
/// Detection, 5.1.5: by the Voronoi regions of its corners and edges).
std::array<float, 2> closest(const glm::vec3& p, const glm::vec3& a, const glm::vec3& ab,
                             const glm::vec3& ac) {
  const glm::vec3 ap = p - a;
  const float d1 = glm::dot(ab, ap);
  const float d2 = glm::dot(ac, ap);
  if (d1 <= 0.0f && d2 <= 0.0f)
    return {0.0f, 0.0f};
  const glm::vec3 bp = ap - ab;
  const float d3 = glm::dot(ab, bp);
  const float d4 = glm::dot(ac, bp);
  if (d3 >= 0.0f && d4 <= d3)
    return {1.0f, 0.0f};
  const float vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0f && d1 >= 0.0f && d3 <= 0.0f)
    return {d1 / (d1 - d3), 0.0f};
  const glm::vec3 cp = ap - ac;
  const float d5 = glm::dot(ab, cp);
  const float d6 = glm::dot(ac, cp);
  if (d6 >= 0.0f && d5 <= d6)
    return {0.0f, 1.0f};
  const float vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0f && d2 >= 0.0f && d6 <= 0.0f)
    return {0.0f, d2 / (d2 - d6)};
  const float va = d3 * d6 - d5 * d4;
  if (va <= 0.0f && d4 >= d3 && d5 >= d6) {
    const float w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {1.0f - w, w};
  }
  const float sum = va + vb + vc;
  return {vb / sum, vc / sum};
}
}  // namespace

Sheet::Sheet(std::span<const TubePoint> net, std::size_t columns, float step) {
  const int across = int(columns);
  const int down = int(net.size() / columns);
  const auto value = [&](int row, int column) {
    const TubePoint& point = net[std::size_t(row) * columns + std::size_t(column)];
    return glm::vec4(point.position, point.radius);
  };
  float longest = step;
  for (int r = 0; r < down; ++r)
    for (int c = 0; c < across; ++c) {
      if (r + 1 < down)
        longest = std::max(longest, glm::length(glm::vec3(value(r + 1, c) - value(r, c))));
      if (c + 1 < across)
        longest = std::max(longest, glm::length(glm::vec3(value(r, c + 1) - value(r, c))));
    }
  const int pieces = int(std::ceil(longest / step));
  const std::size_t rows = std::size_t((down - 1) * pieces + 1);
  const std::size_t finer = std::size_t((across - 1) * pieces + 1);
  for (std::size_t r = 0; r < rows; ++r)
    for (std::size_t c = 0; c < finer; ++c) {
      const auto inRow = [&](int row) {
        return along([&](int column) { return value(row, column); }, across,
                     float(c) / float(pieces));
      };
      const glm::vec4 p = along(inRow, down, float(r) / float(pieces));
      m_points.push_back({glm::vec3(p), std::max(p.w, 0.3f)});
      m_bounds.add(m_points.back().position - m_points.back().radius);
      m_bounds.add(m_points.back().position + m_points.back().radius);
    }
  addPatches(rows, finer);
}

void Sheet::addPatches(std::size_t rows, std::size_t columns) {
  constexpr std::size_t side = 4;
  for (std::size_t top = 0; top + 1 < rows; top += side)
    for (std::size_t left = 0; left + 1 < columns; left += side) {
      Patch patch;
      Box box;
      for (std::size_t r = top; r < std::min(top + side, rows - 1); ++r)
        for (std::size_t c = left; c < std::min(left + side, columns - 1); ++c) {
          const auto a = std::uint32_t(r * columns + c);
          const auto d = std::uint32_t(a + columns);
          patch.triangles.push_back({a, a + 1, d});
          patch.triangles.push_back({a + 1, d + 1, d});
        }
      for (const auto& triangle : patch.triangles)
        for (const std::uint32_t v : triangle)
          box.add(m_points[v].position);
      patch.sphere.centre = box.centre();
      for (const auto& triangle : patch.triangles)
        for (const std::uint32_t v : triangle)
          patch.sphere.radius =
              std::max(patch.sphere.radius,
                       glm::distance(m_points[v].position, box.centre()) + m_points[v].radius);
      m_patches.push_back(std::move(patch));
    }
}

float Sheet::distanceTo(const Patch& patch, const glm::vec3& p) const {
  float best = std::numeric_limits<float>::infinity();
  for (const auto& [ia, ib, ic] : patch.triangles) {
    const TubePoint& a = m_points[ia];
    const TubePoint& b = m_points[ib];
    const TubePoint& c = m_points[ic];
    const glm::vec3 ab = b.position - a.position;
    const glm::vec3 ac = c.position - a.position;
    const auto [u, v] = closest(p, a.position, ab, ac);
    const float radius = a.radius + u * (b.radius - a.radius) + v * (c.radius - a.radius);
    best = std::min(best, glm::length(p - a.position - u * ab - v * ac) - radius);
  }
  return best;
}

float Sheet::distance(const glm::vec3& p) const {
  // As for a tube: far away the box's distance, a lower bound, is as good.
  constexpr float farAway = 12.0f;
  const glm::vec3 outside =
      glm::max(glm::max(m_bounds.low - p, p - m_bounds.high), glm::vec3(0.0f));
  if (const float toBox = glm::length(outside); toBox > farAway)
    return toBox;
  const auto bound = [&p](const Patch& patch) {
    return glm::distance(p, patch.sphere.centre) - patch.sphere.radius;
  };
  // The most promising patch first, so that most of the others need no look at their triangles.
  std::size_t first = 0;
  float lowest = std::numeric_limits<float>::infinity();
  for (std::size_t i = 0; i < m_patches.size(); ++i)
    if (const float b = bound(m_patches[i]); b < lowest) {
      lowest = b;
      first = i;
    }
  float best = distanceTo(m_patches[first], p);
  for (std::size_t i = 0; i < m_patches.size(); ++i)
    if (i != first && bound(m_patches[i]) < best)
      best = std::min(best, distanceTo(m_patches[i], p));
  return best;
}

}  // namespace sline::model
