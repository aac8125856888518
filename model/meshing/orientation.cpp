// SPDX-License-Identifier: Apache-2.0
#include "model/meshing/orientation.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <iterator>
#include <limits>
#include <memory>
#include <numeric>
#include <utility>

namespace sline::model {

namespace {

/// A piece is connected over edges with exactly two triangles.
struct Piece {
  std::vector<std::uint32_t> triangles;
  Box box;
  bool closed = true;
  bool orientable = true;
};

using Positions = std::span<const glm::vec3>;
using Triangles = std::span<Triangle>;

double area(const Triangle& t, Positions p) {
  const glm::dvec3 a(p[t[0]]);
  return 0.5 * glm::length(glm::cross(glm::dvec3(p[t[1]]) - a, glm::dvec3(p[t[2]]) - a));
}

/// Tells whether two half-edges run in the same direction, so that their triangles are turned
/// against each other.
bool sameDirection(Triangles triangles, std::uint32_t a, std::uint32_t b) {
  return triangles[a / 3][a % 3] == triangles[b / 3][b % 3];
}

/// Walks the piece of `seed`; `flip` says for each triangle whether it must turn to agree with it.
Piece walk(Triangles triangles, const HalfEdges& edges, std::uint32_t seed,
           std::vector<signed char>& flip) {
  Piece piece;
  piece.triangles.push_back(seed);
  flip[seed] = 0;
  for (std::size_t next = 0; next < piece.triangles.size(); ++next) {
    const std::uint32_t t = piece.triangles[next];
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t h = 3 * t + k;
      if (!edges.hasOpposite(h)) {
        piece.closed = false;
        continue;
      }
      const std::uint32_t other = edges.opposite(h);
      const auto wanted =
          static_cast<signed char>(sameDirection(triangles, h, other) ? 1 - flip[t] : flip[t]);
      signed char& state = flip[other / 3];
      if (state < 0) {
        state = wanted;
        piece.triangles.push_back(other / 3);
      } else if (state != wanted) {
        piece.orientable = false;
      }
    }
  }
  return piece;
}

double signedVolume(const Piece& piece, Positions p, Triangles triangles) {
  const glm::dvec3 origin(piece.box.centre());
  double sum = 0.0;
  for (const std::uint32_t t : piece.triangles) {
    const Triangle& v = triangles[t];
    sum += glm::dot(glm::dvec3(p[v[0]]) - origin,
                    glm::cross(glm::dvec3(p[v[1]]) - origin, glm::dvec3(p[v[2]]) - origin));
  }
  return sum / 6.0;
}

/// Counts how often the ray from a point along +x crosses one piece. Triangles stand in the cells
/// of a grid over y and z, so that many small pieces inside a large one stay cheap.
class CrossingCounter {
 public:
  CrossingCounter(const Piece& piece, Positions p, Triangles triangles)
      : m_positions(p), m_triangles(triangles), m_low(piece.box.low.y, piece.box.low.z) {
    const std::vector<std::uint32_t>& own = piece.triangles;
    const glm::vec3 size = piece.box.size();
    m_side = std::uint32_t(std::sqrt(double(own.size()) / trianglesOfCell));
    std::size_t entries = 0;
    // A mesh of needles has as many as fit, in larger cells.
    do {
      m_side = std::max(1U, m_side);
      m_scale = float(m_side) / glm::max(glm::vec2(size.y, size.z), glm::vec2(1e-30f));
      entries = 0;
      for (const std::uint32_t t : own)
        entries += cellsOf(t).count();
    } while (entries > mostEntries * own.size() && (m_side /= 2) > 0);
    m_first.resize(std::size_t(m_side) * m_side + 1, 0);
    forEachCell(own, [this](std::size_t cell, std::uint32_t) { ++m_first[cell + 1]; });
    std::partial_sum(m_first.begin(), m_first.end(), m_first.begin());
    std::vector<std::size_t> next(m_first.begin(), std::prev(m_first.end()));
    m_entries.resize(entries);
    forEachCell(own, [&](std::size_t cell, std::uint32_t t) { m_entries[next[cell]++] = t; });
  }

  bool oddFrom(const glm::dvec3& from) const {
    const auto [y, z] = cellAt({float(from.y), float(from.z)});
    const std::size_t cell = std::size_t(z) * m_side + y;
    bool odd = false;
    for (std::size_t i = m_first[cell]; i < m_first[cell + 1]; ++i)
      odd ^= crosses(m_triangles[m_entries[i]], from);
    return odd;
  }

 private:
  static constexpr double trianglesOfCell = 4.0;
  static constexpr std::size_t mostEntries = 16;  ///< of each triangle, on an average

  struct Cell {
    std::uint32_t y;
    std::uint32_t z;
  };
  /// The cells from `low` to `high`, both included.
  struct Cells {
    Cell low;
    Cell high;
    std::size_t count() const {
      return std::size_t(high.y - low.y + 1) * std::size_t(high.z - low.z + 1);
    }
  };

  /// Places outside are in the nearest cell; those of a piece without size in the first.
  Cell cellAt(const glm::vec2& place) const {
    const glm::vec2 inside = glm::max(glm::vec2(0.0f), (place - m_low) * m_scale);
    const glm::vec2 at = glm::min(glm::vec2(float(m_side - 1)), inside);
    return {std::uint32_t(at.x), std::uint32_t(at.y)};
  }
  Cells cellsOf(std::uint32_t triangle) const {
    glm::vec2 low(std::numeric_limits<float>::infinity());
    glm::vec2 high(-std::numeric_limits<float>::infinity());
    for (const std::uint32_t v : m_triangles[triangle]) {
      const glm::vec2 place(m_positions[v].y, m_positions[v].z);
      low = glm::min(low, place);
      high = glm::max(high, place);
    }
    return {cellAt(low), cellAt(high)};
  }
  template <class Body>
  void forEachCell(std::span<const std::uint32_t> triangles, const Body& body) const {
    for (const std::uint32_t t : triangles) {
      const Cells cells = cellsOf(t);
      for (std::uint32_t z = cells.low.z; z <= cells.high.z; ++z)
        for (std::uint32_t y = cells.low.y; y <= cells.high.y; ++y)
          body(std::size_t(z) * m_side + y, t);
    }
  }

  bool crosses(const Triangle& t, const glm::dvec3& from) const {
    const glm::dvec3 a = glm::dvec3(m_positions[t[0]]) - from;
    const glm::dvec3 b = glm::dvec3(m_positions[t[1]]) - from;
    const glm::dvec3 c = glm::dvec3(m_positions[t[2]]) - from;
    // The test is half-open in y, so that a ray through a shared edge or vertex counts once.
    if ((a.y > 0) == (b.y > 0) && (b.y > 0) == (c.y > 0))
      return false;
    const glm::dvec3 n = glm::cross(b - a, c - a);
    const auto side = [](const glm::dvec3& u, const glm::dvec3& v) {
      return u.y * v.z - u.z * v.y;
    };
    const double ab = side(a, b);
    const double bc = side(b, c);
    const double ca = side(c, a);
    const bool within = (ab > 0 && bc > 0 && ca > 0) || (ab < 0 && bc < 0 && ca < 0);
    return within && n.x != 0.0 && glm::dot(n, a) / n.x > 0.0;
  }

  Positions m_positions;
  Triangles m_triangles;
  glm::vec2 m_low;
  glm::vec2 m_scale{0.0f};           ///< cells per mm along y and z
  std::uint32_t m_side = 1;          ///< cells each way
  std::vector<std::size_t> m_first;  ///< of each cell's entries, and one behind the last
  std::vector<std::uint32_t> m_entries;
};

bool contains(const Box& outer, const Box& inner) {
  return outer.low.x < inner.low.x && outer.low.y < inner.low.y && outer.low.z < inner.low.z &&
         outer.high.x > inner.high.x && outer.high.y > inner.high.y && outer.high.z > inner.high.z;
}

/// Returns for each piece whether it is closed and lies inside an odd number of other closed
/// pieces.
std::vector<char> cavities(const std::vector<Piece>& pieces, Positions p, Triangles triangles) {
  std::vector<char> odd(pieces.size(), 0);
  std::vector<std::size_t> closed;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    if (pieces[i].closed)
      closed.push_back(i);
  const auto lowX = [&](std::size_t i) { return pieces[i].box.low.x; };
  std::sort(closed.begin(), closed.end(),
            [&](std::size_t a, std::size_t b) { return lowX(a) < lowX(b); });
  for (std::size_t place = 0; place < closed.size(); ++place) {
    const Piece& outer = pieces[closed[place]];
    std::unique_ptr<CrossingCounter> counter;
    for (std::size_t next = place + 1; next < closed.size(); ++next) {
      const Piece& inner = pieces[closed[next]];
      if (inner.box.low.x >= outer.box.high.x)
        break;
      if (!contains(outer.box, inner.box))
        continue;
      if (!counter)
        counter = std::make_unique<CrossingCounter>(outer, p, triangles);
      // The ray starts near the middle of a face, slightly off the lattices on which segmentations
      // lie.
      const Triangle& t = triangles[inner.triangles.front()];
      const glm::dvec3 from =
          0.351 * glm::dvec3(p[t[0]]) + 0.337 * glm::dvec3(p[t[1]]) + 0.312 * glm::dvec3(p[t[2]]);
      odd[closed[next]] ^= char(counter->oddFrom(from));
    }
  }
  return odd;
}

void turn(Triangles triangles, const Piece& piece) {
  for (const std::uint32_t t : piece.triangles)
    std::swap(triangles[t][1], triangles[t][2]);
}

/// Applies the walk's result, keeping the orientation that most of the area has.
void makeConsistent(const Piece& piece, Positions p, Triangles triangles,
                    const std::vector<signed char>& flip) {
  double kept = 0.0;
  double turned = 0.0;
  for (const std::uint32_t t : piece.triangles)
    (flip[t] == 1 ? turned : kept) += area(triangles[t], p);
  const signed char odd = turned > kept ? 0 : 1;
  for (const std::uint32_t t : piece.triangles)
    if (flip[t] == odd)
      std::swap(triangles[t][1], triangles[t][2]);
}

}  // namespace

Orientation orient(Positions positions, Triangles triangles, const HalfEdges& edges) {
  Orientation result;
  std::vector<signed char> flip(triangles.size(), -1);
  std::vector<Piece> pieces;
  const std::vector<Triangle> original(triangles.begin(), triangles.end());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    if (flip[t] >= 0)
      continue;
    Piece piece = walk(triangles, edges, t, flip);
    for (const std::uint32_t member : piece.triangles)
      for (const std::uint32_t v : triangles[member])
        piece.box.add(positions[v]);
    if (piece.orientable)
      makeConsistent(piece, positions, triangles, flip);
    else
      result.notOrientable = true;
    piece.closed = piece.closed && piece.orientable;
    pieces.push_back(std::move(piece));
  }
  const std::vector<char> cavity = cavities(pieces, positions, triangles);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (!pieces[i].closed)
      continue;
    const double volume = signedVolume(pieces[i], positions, triangles);
    if (volume != 0.0 && (volume < 0.0) != (cavity[i] != 0))
      turn(triangles, pieces[i]);
  }
  for (std::size_t t = 0; t < triangles.size(); ++t)
    result.turned += triangles[t] != original[t];
  return result;
}

}  // namespace sline::model
