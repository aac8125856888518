// SPDX-License-Identifier: Apache-2.0
#include "model/cuts/odd_even_fill.h"

#include <algorithm>
#include <cmath>

namespace sline::model {

namespace {

constexpr std::uint32_t nowhere = ~0u;

/// An edge that is not horizontal runs from its lower to its upper end; levels number the heights
/// of all ends from below.
struct Edge {
  glm::dvec2 low;
  glm::dvec2 high;
  std::uint32_t lowLevel;
  std::uint32_t highLevel;

  double xAt(double y) const { return low.x + (y - low.y) / (high.y - low.y) * (high.x - low.x); }
};

/// A trapezoid is the area between two edges from one level to another.
struct Trapezoid {
  std::uint32_t left;
  std::uint32_t right;
  std::uint32_t lowLevel;
  std::uint32_t highLevel;
};

/// Sweeps the plane upwards, one slab between neighbouring heights after the other. Within a slab
/// the edges keep their order, and every second gap between them is inside; a gap between the same
/// two edges grows from slab to slab into one trapezoid.
class Sweep {
 public:
  explicit Sweep(std::vector<std::array<glm::dvec2, 2>> edges) {
    snapHeights(edges);
    for (const auto& edge : edges)
      for (const glm::dvec2& p : edge)
        m_heights.push_back(p.y);
    std::sort(m_heights.begin(), m_heights.end());
    m_heights.erase(std::unique(m_heights.begin(), m_heights.end()), m_heights.end());
    for (const auto& [a, b] : edges) {
      if (a.y == b.y)
        continue;
      const glm::dvec2& low = a.y < b.y ? a : b;
      const glm::dvec2& high = a.y < b.y ? b : a;
      m_edges.push_back({low, high, level(low.y), level(high.y)});
    }
    std::sort(m_edges.begin(), m_edges.end(),
              [](const Edge& a, const Edge& b) { return a.lowLevel < b.lowLevel; });
  }

  FlatFill fill() {
    findTrapezoids();
    return triangulated();
  }

 private:
  struct Active {
    std::uint32_t edge;
    double x;  ///< in the middle of the slab
  };
  /// A gap that may continue in the next slab.
  struct Open {
    std::uint32_t right = nowhere;
    std::uint32_t since = 0;
    std::uint32_t seen = nowhere;  ///< the last slab in which it was found
  };

  /// Rounds heights to multiples of a length below the resolution of a float of the outline's size.
  /// Ends that differ by rounding alone would otherwise make slabs too thin to tell left from
  /// right.
  static void snapHeights(std::vector<std::array<glm::dvec2, 2>>& edges) {
    double largest = 0.0;
    for (const auto& edge : edges)
      for (const glm::dvec2& p : edge)
        largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
    if (!(largest > 0.0))
      return;
    const double grain = std::exp2(std::ceil(std::log2(largest)) - 26.0);
    for (auto& edge : edges)
      for (glm::dvec2& p : edge)
        p.y = std::round(p.y / grain) * grain;
  }

  std::uint32_t level(double y) const {
    return std::uint32_t(std::lower_bound(m_heights.begin(), m_heights.end(), y) -
                         m_heights.begin());
  }

  /// Returns exactly the same number for every trapezoid that has this corner.
  double cornerX(std::uint32_t edge, std::uint32_t atLevel) const {
    const Edge& e = m_edges[edge];
    if (atLevel == e.lowLevel)
      return e.low.x;
    return atLevel == e.highLevel ? e.high.x : e.xAt(m_heights[atLevel]);
  }

  void findTrapezoids() {
    std::vector<Active> active;
    std::vector<Open> open(m_edges.size());  // by left edge
    std::vector<std::uint32_t> lefts;        // left edges of all open gaps
    std::size_t next = 0;
    for (std::uint32_t slab = 0; slab + 1 < m_heights.size(); ++slab) {
      std::erase_if(active, [&](const Active& a) { return m_edges[a.edge].highLevel <= slab; });
      for (; next < m_edges.size() && m_edges[next].lowLevel == slab; ++next)
        active.push_back({std::uint32_t(next), 0.0});
      sortAcross(active, 0.5 * (m_heights[slab] + m_heights[slab + 1]));
      std::vector<std::uint32_t> now;
      for (std::size_t i = 0; i + 1 < active.size(); i += 2) {
        const std::uint32_t left = active[i].edge;
        const std::uint32_t right = active[i + 1].edge;
        now.push_back(left);
        if (open[left].right != right) {
          close(left, open[left], slab);
          open[left] = {right, slab, slab};
        }
        open[left].seen = slab;
      }
      for (const std::uint32_t left : lefts)
        if (open[left].seen != slab)
          close(left, open[left], slab);
      lefts = std::move(now);
    }
    for (const std::uint32_t left : lefts)
      close(left, open[left], std::uint32_t(m_heights.size() - 1));
  }

  /// Sorts by insertion, which beats a full sort because the order hardly changes from one slab to
  /// the next.
  void sortAcross(std::vector<Active>& active, double y) const {
    for (Active& a : active)
      a.x = m_edges[a.edge].xAt(y);
    for (std::size_t i = 1; i < active.size(); ++i) {
      const Active moving = active[i];
      std::size_t at = i;
      for (; at > 0 && active[at - 1].x > moving.x; --at)
        active[at] = active[at - 1];
      active[at] = moving;
    }
  }

  void close(std::uint32_t left, Open& gap, std::uint32_t atLevel) {
    if (gap.right != nowhere && gap.since < atLevel)
      m_trapezoids.push_back({left, gap.right, gap.since, atLevel});
    gap.right = nowhere;
  }

  /// Collects the corners of all trapezoids on each level from left to right: those within a
  /// trapezoid's side become corners of its triangles too.
  FlatFill triangulated() const {
    std::vector<std::vector<double>> corners(m_heights.size());
    for (const Trapezoid& t : m_trapezoids)
      for (const std::uint32_t edge : {t.left, t.right})
        for (const std::uint32_t atLevel : {t.lowLevel, t.highLevel})
          corners[atLevel].push_back(cornerX(edge, atLevel));
    FlatFill fill;
    std::vector<std::uint32_t> first(m_heights.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
      std::sort(corners[i].begin(), corners[i].end());
      corners[i].erase(std::unique(corners[i].begin(), corners[i].end()), corners[i].end());
      first[i] = std::uint32_t(fill.points.size());
      for (const double x : corners[i])
        fill.points.emplace_back(x, m_heights[i]);
    }
    const auto side = [&](const Trapezoid& t, std::uint32_t atLevel) {
      const auto [low, high] = std::minmax({cornerX(t.left, atLevel), cornerX(t.right, atLevel)});
      const auto& row = corners[atLevel];
      const auto index = [&](double x) {
        return first[atLevel] +
               std::uint32_t(std::lower_bound(row.begin(), row.end(), x) - row.begin());
      };
      return std::array<std::uint32_t, 2>{index(low), index(high)};
    };
    for (const Trapezoid& t : m_trapezoids)
      zip(side(t, t.lowLevel), side(t, t.highLevel), fill);
    return fill;
  }

  /// Adds the triangles between two rows of points, each given by its first and last point.
  static void zip(std::array<std::uint32_t, 2> below, std::array<std::uint32_t, 2> above,
                  FlatFill& fill) {
    const auto add = [&fill](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      const glm::dvec2 ab = fill.points[b] - fill.points[a];
      const glm::dvec2 ac = fill.points[c] - fill.points[a];
      fill.triangles.push_back({a, b, c});
      fill.area += 0.5 * (ab.x * ac.y - ab.y * ac.x);
    };
    auto [low, lastLow] = below;
    auto [high, lastHigh] = above;
    while (low < lastLow || high < lastHigh) {
      const bool onLow =
          high == lastHigh || (low < lastLow && fill.points[low + 1].x < fill.points[high + 1].x);
      if (onLow) {
        add(low, low + 1, high);
        ++low;
      } else {
        add(low, high + 1, high);
        ++high;
      }
    }
  }

  std::vector<double> m_heights;
  std::vector<Edge> m_edges;
  std::vector<Trapezoid> m_trapezoids;
};

}  // namespace

FlatFill oddEvenFill(std::span<const std::array<glm::dvec2, 2>> edges) {
  return edges.empty() ? FlatFill{} : Sweep({edges.begin(), edges.end()}).fill();
}

}  // namespace sline::model
