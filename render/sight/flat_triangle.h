// SPDX-License-Identifier: Apache-2.0
// Tells which cells of a grid a triangle covers, and where in the triangle they lie: the one way in
// which vector drawings, labels and cut faces draw triangles, whatever a cell is. (Wide loops that
// draw whole surfaces as pixels keep a form of their own, `render/software/seen_cluster.h`.)
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/raster/pixel_rect.h"

namespace sline::render {

/// A triangle as it lies in a grid whose cell (x, y) has its middle at (x + ½, y + ½).
class FlatTriangle {
 public:
  /// `corners` in cells; `nearness`: 1 / the distance of each from the eye's plane, all the same in
  /// a parallel projection.
  FlatTriangle(const std::array<glm::vec2, 3>& corners, const glm::vec3& nearness)
      : m_corner(corners[0]),
        m_ab(corners[1] - corners[0]),
        m_ac(corners[2] - corners[0]),
        m_low(glm::min(glm::min(corners[0], corners[1]), corners[2])),
        m_high(glm::max(glm::max(corners[0], corners[1]), corners[2])),
        m_nearness(nearness),
        m_area(crossed(m_ab, m_ac)) {}

  /// Returns the cells within the area that have their middle in the triangle's box.
  PixelRect box(const PixelRect& area) const {
    const glm::vec2 low(area.x, area.y);
    const glm::vec2 high(area.right(), area.top());
    // Triangles of any size, also of none that is a number.
    if (area.empty() ||
        !(m_high.x >= low.x && m_high.y >= low.y && m_low.x <= high.x && m_low.y <= high.y))
      return {};
    const glm::ivec2 first(glm::ceil(glm::max(m_low, low) - 0.5f));
    const glm::ivec2 last(glm::floor(glm::min(m_high, high) - 0.5f));
    return intersection({first.x, first.y, last.x - first.x + 1, last.y - first.y + 1}, area);
  }

  /// Returns the corners' shares at a place, in the grid's plane; they add up to 1. A triangle that
  /// is seen on edge has none.
  glm::vec3 sharesAt(const glm::vec2& place) const {
    const glm::vec2 ap = place - m_corner;
    const float b = crossed(ap, m_ac) / m_area;
    const float c = crossed(m_ab, ap) / m_area;
    return {1.0f - b - c, b, c};
  }
  /// Tells whether a place with those shares lies within; one on an edge belongs to both triangles
  /// there, so that no gap is left between.
  static bool holds(const glm::vec3& shares) {
    constexpr float onEdge = -1e-5f;
    return shares.x >= onEdge && shares.y >= onEdge && shares.z >= onEdge;
  }
  /// Converts such shares to those on the triangle itself, as perspective foreshortens it.
  glm::vec3 inSpace(const glm::vec3& shares) const {
    const glm::vec3 near = shares * m_nearness;
    return near / (near.x + near.y + near.z);
  }

  /// Calls draw(x, y, shares) for each cell of the area that has its middle in the triangle.
  template <class Draw>
  void forEachCell(const PixelRect& area, const Draw& draw) const {
    const PixelRect cells = box(area);
    if (m_area == 0.0f)
      return;
    for (int y = cells.y; y < cells.top(); ++y)
      for (int x = cells.x; x < cells.right(); ++x) {
        const glm::vec3 shares = sharesAt({float(x) + 0.5f, float(y) + 0.5f});
        if (holds(shares))
          draw(x, y, shares);
      }
  }

 private:
  static float crossed(const glm::vec2& a, const glm::vec2& b) { return a.x * b.y - a.y * b.x; }

  glm::vec2 m_corner;
  glm::vec2 m_ab;
  glm::vec2 m_ac;
  glm::vec2 m_low;
  glm::vec2 m_high;
  glm::vec3 m_nearness;
  float m_area;  ///< doubled
};

}  // namespace sline::render
