// SPDX-License-Identifier: Apache-2.0
#include "model/import/molecules/surface/lattice_cuts.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <span>
#include <tuple>

namespace sline::model {

namespace {

constexpr std::uint32_t none = 0xffffffffu;

/// Lists the fourteen neighbours of a lattice point: eight near ones along the cubes' diagonals and
/// six far ones along the axes.
constexpr std::array<LatticePoint, 14> neighbours = {{{1, 1, 1},
                                                      {-1, 1, 1},
                                                      {1, -1, 1},
                                                      {-1, -1, 1},
                                                      {1, 1, -1},
                                                      {-1, 1, -1},
                                                      {1, -1, -1},
                                                      {-1, -1, -1},
                                                      {2, 0, 0},
                                                      {-2, 0, 0},
                                                      {0, 2, 0},
                                                      {0, -2, 0},
                                                      {0, 0, 2},
                                                      {0, 0, -2}}};
constexpr unsigned everyNeighbour = (1u << neighbours.size()) - 1;

constexpr int square(int x) {
  return x * x;
}

/// Returns for each neighbour the others that share a lattice edge with it.
constexpr std::array<unsigned, 14> linkOf() {
  std::array<unsigned, 14> link{};
  for (std::size_t i = 0; i < neighbours.size(); ++i)
    for (std::size_t k = 0; k < neighbours.size(); ++k) {
      const int apart = square(neighbours[i].x - neighbours[k].x) +
                        square(neighbours[i].y - neighbours[k].y) +
                        square(neighbours[i].z - neighbours[k].z);
      if (apart == 3 || apart == 4)
        link[i] |= 1u << k;
    }
  return link;
}
constexpr std::array<unsigned, 14> links = linkOf();

bool isConnected(unsigned set) {
  if (set == 0)
    return false;
  unsigned reached = set & (~set + 1);
  for (unsigned before = 0; before != reached;) {
    before = reached;
    for (std::size_t i = 0; i < neighbours.size(); ++i)
      if ((reached >> i & 1u) != 0)
        reached |= links[i] & set;
  }
  return reached == set;
}

/// Describes a lattice point at one end of a cut.
struct End {
  LatticePoint point;
  std::uint32_t cut = 0;
  bool outside = false;
};

class CutMesher {
 public:
  explicit CutMesher(CutSurface surface) : m_surface(std::move(surface)) {
    mergeCuts();
    findEnds();
  }

  TriangleMesh mesh() {
    std::vector<char> keep(m_points.size(), 0);
    for (int round = 0;; ++round) {
      snap(keep);
      connect();
      if (round == lastRound || !findFaults(keep))
        return build();
      if (round == lastRound - 1)
        std::fill(keep.begin(), keep.end(), char(1));
    }
  }

 private:
  static constexpr int lastRound = 6;

  const Cut& cut(std::size_t i) const { return m_surface.cuts[i]; }

  /// Merges cuts of the same edge in several blocks into one cut.
  void mergeCuts() {
    std::vector<Cut>& cuts = m_surface.cuts;
    std::vector<std::uint32_t> order(cuts.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto key = [&](std::uint32_t i) { return std::tie(cuts[i].inside, cuts[i].outside); };
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    std::vector<std::uint32_t> place(cuts.size());
    std::vector<Cut> merged;
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (i == 0 || key(order[i - 1]) != key(order[i]))
        merged.push_back(cuts[order[i]]);
      place[order[i]] = std::uint32_t(merged.size() - 1);
    }
    cuts = std::move(merged);
    for (Triangle& t : m_surface.triangles)
      t = {place[t[0]], place[t[1]], place[t[2]]};
  }

  /// Lists the lattice points at the cuts' ends and the cuts around each.
  void findEnds() {
    m_ends.reserve(2 * m_surface.cuts.size());
    for (std::uint32_t i = 0; i < m_surface.cuts.size(); ++i) {
      m_ends.push_back({cut(i).inside, i, false});
      m_ends.push_back({cut(i).outside, i, true});
    }
    std::sort(m_ends.begin(), m_ends.end(), [](const End& a, const End& b) {
      return std::tie(a.point, a.cut) < std::tie(b.point, b.cut);
    });
    m_pointAt.assign(2 * m_surface.cuts.size(), none);
    for (std::size_t i = 0; i < m_ends.size(); ++i) {
      if (i == 0 || m_ends[i - 1].point != m_ends[i].point)
        m_points.push_back(std::uint32_t(i));
      m_pointAt[2 * std::size_t(m_ends[i].cut) + (m_ends[i].outside ? 1 : 0)] =
          std::uint32_t(m_points.size() - 1);
    }
  }

  std::span<const End> endsOf(std::size_t point) const {
    const std::size_t last = point + 1 < m_points.size() ? m_points[point + 1] : m_ends.size();
    return std::span(m_ends).subspan(m_points[point], last - m_points[point]);
  }

  /// Tells whether the surface is near the end of the cut edge; the two thresholds, for long and
  /// short edges, are those of Labelle & Shewchuk.
  bool isNear(const End& end) const {
    const Cut& c = cut(end.cut);
    const bool along = square(c.inside.x - c.outside.x) + square(c.inside.y - c.outside.y) +
                           square(c.inside.z - c.outside.z) ==
                       4;
    return (end.outside ? 1.0f - c.share : c.share) < (along ? 0.249f : 0.413f);
  }

  /// Tells whether the surface near the lattice point is one sheet, so that its cuts may become one
  /// vertex.
  bool isOneSheet(std::span<const End> ends) const {
    unsigned across = 0;
    for (const End& end : ends) {
      const LatticePoint& other = end.outside ? cut(end.cut).inside : cut(end.cut).outside;
      const LatticePoint step{other.x - end.point.x, other.y - end.point.y, other.z - end.point.z};
      const auto* const found = std::find(neighbours.begin(), neighbours.end(), step);
      across |= 1u << (found - neighbours.begin());
    }
    return isConnected(across) && isConnected(everyNeighbour & ~across);
  }

  float nearest(std::span<const End> ends) const {
    float least = 1.0f;
    for (const End& end : ends)
      least = std::min(least, end.outside ? 1.0f - cut(end.cut).share : cut(end.cut).share);
    return least;
  }

  /// Chooses the lattice points that move onto the surface, the nearest first.
  void snap(const std::vector<char>& keep) {
    m_snapped.assign(m_points.size(), 0);
    std::vector<std::pair<float, std::uint32_t>> order;
    for (std::uint32_t p = 0; p < m_points.size(); ++p) {
      const auto ends = endsOf(p);
      if (keep[p] == 0 &&
          std::any_of(ends.begin(), ends.end(), [&](const End& e) { return isNear(e); }) &&
          isOneSheet(ends))
        order.emplace_back(nearest(ends), p);
    }
    std::sort(order.begin(), order.end());
    for (const auto& [share, p] : order) {
      // Where the other end of a cut has moved already, that cut belongs to the other end.
      const auto ends = endsOf(p);
      m_snapped[p] = char(std::none_of(ends.begin(), ends.end(), [&](const End& e) {
        return m_snapped[m_pointAt[2 * std::size_t(e.cut) + (e.outside ? 0 : 1)]] != 0;
      }));
    }
  }

  /// Numbers the vertices and the triangles that are left.
  void connect() {
    const std::size_t count = m_surface.cuts.size();
    m_vertexOf.assign(count, none);
    std::vector<std::uint32_t> vertexOfPoint(m_points.size(), none);
    m_places.clear();
    m_owner.clear();
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t in = m_pointAt[2 * std::size_t(i)];
      const std::uint32_t out = m_pointAt[2 * std::size_t(i) + 1];
      const std::uint32_t point = m_snapped[in] != 0 ? in : m_snapped[out] != 0 ? out : none;
      std::uint32_t& vertex = point == none ? m_vertexOf[i] : vertexOfPoint[point];
      if (vertex == none) {
        vertex = std::uint32_t(m_places.size());
        m_places.push_back(point == none ? cut(i).place
                           : point == in ? cut(i).insidePlace
                                         : cut(i).outsidePlace);
        m_owner.push_back(point);
      }
      m_vertexOf[i] = vertex;
    }
    m_triangles.clear();
    for (const Triangle& t : m_surface.triangles) {
      const Triangle v = {m_vertexOf[t[0]], m_vertexOf[t[1]], m_vertexOf[t[2]]};
      if (v[0] != v[1] && v[1] != v[2] && v[2] != v[0])
        m_triangles.push_back(v);
    }
  }

  /// Marks the lattice points at vertices where the triangles are no manifold; returns false where
  /// there is none.
  bool findFaults(std::vector<char>& keep) const {
    struct Half {
      std::uint32_t low;
      std::uint32_t high;
      std::uint32_t half;
    };
    std::vector<Half> halves;
    halves.reserve(3 * m_triangles.size());
    for (std::uint32_t t = 0; t < m_triangles.size(); ++t)
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t a = m_triangles[t][k];
        const std::uint32_t b = m_triangles[t][(k + 1) % 3];
        halves.push_back({std::min(a, b), std::max(a, b), 3 * t + k});
      }
    std::sort(halves.begin(), halves.end(), [](const Half& a, const Half& b) {
      return std::tie(a.low, a.high, a.half) < std::tie(b.low, b.high, b.half);
    });
    bool faults = false;
    const auto blame = [&](std::uint32_t vertex) {
      faults = true;
      if (m_owner[vertex] != none)
        keep[m_owner[vertex]] = 1;
    };
    std::vector<std::uint32_t> opposite(halves.size(), none);
    for (std::size_t i = 0; i < halves.size();) {
      std::size_t end = i + 1;
      while (end < halves.size() && halves[end].low == halves[i].low &&
             halves[end].high == halves[i].high)
        ++end;
      const bool pair = end == i + 2 && from(halves[i].half) != from(halves[i + 1].half);
      if (pair) {
        opposite[halves[i].half] = halves[i + 1].half;
        opposite[halves[i + 1].half] = halves[i].half;
      } else {
        blame(halves[i].low);
        blame(halves[i].high);
      }
      i = end;
    }
    if (!faults)
      forEachSecondFan(opposite, blame);
    return faults;
  }

  std::uint32_t from(std::uint32_t half) const { return m_triangles[half / 3][half % 3]; }

  /// Calls `found` for each vertex at which more than one fan of triangles meets.
  template <class Found>
  void forEachSecondFan(const std::vector<std::uint32_t>& opposite, const Found& found) const {
    std::vector<char> seen(opposite.size(), 0);
    std::vector<char> hasFan(m_places.size(), 0);
    for (std::uint32_t first = 0; first < opposite.size(); ++first) {
      if (seen[first] != 0)
        continue;
      for (std::uint32_t h = first; seen[h] == 0;) {
        seen[h] = 1;
        h = opposite[h - h % 3 + (h + 2) % 3];
      }
      char& fan = hasFan[from(first)];
      if (fan != 0)
        found(from(first));
      fan = 1;
    }
  }

  TriangleMesh build() {
    // Vertices that have lost all their triangles are left out.
    std::vector<std::uint32_t> number(m_places.size(), none);
    TriangleMesh mesh;
    for (Triangle t : m_triangles) {
      for (std::uint32_t& v : t) {
        if (number[v] == none) {
          number[v] = std::uint32_t(mesh.positions.size());
          mesh.positions.push_back(m_places[v]);
        }
        v = number[v];
      }
      mesh.triangles.push_back(t);
    }
    return mesh;
  }

  CutSurface m_surface;
  std::vector<End> m_ends;               ///< by point
  std::vector<std::uint32_t> m_points;   ///< where each point's ends begin in m_ends
  std::vector<std::uint32_t> m_pointAt;  ///< points of the inner and the outer end of each cut
  std::vector<char> m_snapped;
  std::vector<std::uint32_t> m_vertexOf;
  std::vector<glm::vec3> m_places;
  std::vector<std::uint32_t> m_owner;  ///< the lattice point that a vertex came from, or none
  std::vector<Triangle> m_triangles;
};

}  // namespace

TriangleMesh meshOf(CutSurface surface) {
  return CutMesher(std::move(surface)).mesh();
}

}  // namespace sline::model
