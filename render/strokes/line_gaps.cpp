// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <tuple>
#include <utility>

#include "render/strokes/continuation.h"
#include "render/strokes/line_curves.h"

namespace sline::render {

namespace {

// The way over which an end's direction is taken, λ.
constexpr float directionReach = 4.0f;
// Ends that lie together in the picture may be this many times as far apart in depth.
constexpr float depthShare = 4.0f;
// The fewest segments of a line whose ends may meet.
constexpr std::size_t fewestOfRing = 8;

struct LineEnd {
  std::size_t chain;
  std::uint32_t segment;
  bool atB;   ///< the end is the segment's b
  bool last;  ///< it is the chain's end, not its beginning
  glm::vec2 pixel;
  glm::vec2 direction;  ///< away from the line, unit
  std::size_t links;    ///< of the chain
};

const glm::vec3& placeOf(const std::vector<Segment>& segments, const LineEnd& end) {
  const Segment& s = segments[end.segment];
  return end.atB ? s.b : s.a;
}

class EndFinder {
 public:
  EndFinder(const Chains& chains, const ChainPoints& points, const PictureView& view)
      : m_chains(chains), m_points(points), m_reach(directionReach * view.outputUnit()) {}

  std::vector<LineEnd> ends(const std::vector<Segment>& segments) const {
    std::vector<LineEnd> found;
    for (std::size_t chain = 0; chain < m_chains.count(); ++chain) {
      const Chains::Link& first = m_chains.links[m_chains.first[chain]];
      const Chains::Link& last = m_chains.links[m_chains.first[chain + 1] - 1];
      const Segment& a = segments[first.segment];
      const Segment& b = segments[last.segment];
      if ((first.reversed ? a.b : a.a) == (last.reversed ? b.a : b.b) &&
          m_chains.first[chain + 1] - m_chains.first[chain] > 1)
        continue;  // closed
      add(chain, false, found);
      add(chain, true, found);
    }
    return found;
  }

 private:
  void add(std::size_t chain, bool atEnd, std::vector<LineEnd>& found) const {
    const std::span<const ChainPoints::Point> points = m_points.of(m_chains, chain);
    const ChainPoints::Point& at = atEnd ? points.back() : points.front();
    if (!(at.w > 0.0f))
      return;
    glm::vec2 inner = at.pixel;
    for (std::size_t i = 1; i < points.size(); ++i) {
      inner = points[atEnd ? points.size() - 1 - i : i].pixel;
      if (glm::distance(inner, at.pixel) > m_reach)
        break;
    }
    const float length = glm::distance(inner, at.pixel);
    if (!(length > 0.0f) || !std::isfinite(length))
      return;
    const std::uint32_t link = atEnd ? m_chains.first[chain + 1] - 1 : m_chains.first[chain];
    const Chains::Link& l = m_chains.links[link];
    found.push_back({chain, l.segment, atEnd != l.reversed, atEnd, at.pixel,
                     (at.pixel - inner) / length, points.size() - 1});
  }

  const Chains& m_chains;
  const ChainPoints& m_points;
  float m_reach;  ///< px
};

struct Pair {
  float distance;
  std::size_t a;
  std::size_t b;
  std::uint64_t place;  ///< decides where distances are equal
};

/// Finds ends that lie near each other in the picture, by cells as wide as their reach. A cell and
/// an end in it are one number, so that they are sorted quickly: row, column, end.
class EndGrid {
 public:
  EndGrid(const std::vector<LineEnd>& ends, float reach) {
    m_order.reserve(ends.size());
    for (std::size_t i = 0; i < std::min(ends.size(), mostEnds); ++i) {
      const glm::vec2 at = ends[i].pixel / reach;
      if (std::max(std::abs(at.x), std::abs(at.y)) < farthest)
        m_order.push_back(key(int(std::floor(at.y)), int(std::floor(at.x)), i));
    }
    std::sort(m_order.begin(), m_order.end());
  }

  /// Calls `body` for each end and each earlier one in the cells around it, with the number of the
  /// earlier one's place in the order of rows and columns. Where thousands lie in one place, as
  /// where the edges of so many triangles meet, some of them are enough.
  template <class Body>
  void forEachPair(const Body& body) const {
    std::array<std::size_t, 3> from{};  // where cells of the rows around begin that are near enough
    for (const std::uint64_t own : m_order) {
      const std::size_t end = own & endMask;
      const std::uint64_t cell = own - end;
      for (std::size_t row = 0; row < 3; ++row) {
        const std::uint64_t there = cell + row * nextRow - nextRow;
        while (from[row] < m_order.size() && m_order[from[row]] < there - nextColumn)
          ++from[row];
        const std::size_t most = std::min(m_order.size(), from[row] + mostInRow);
        for (std::size_t k = from[row]; k < most && m_order[k] < there + 2 * nextColumn; ++k)
          if (const std::size_t other = m_order[k] & endMask; other < end)
            body(end, other, m_order[k]);
      }
    }
  }

 private:
  // Columns and rows have 20 bits, ends the rest.
  static constexpr int cellBits = 20;
  static constexpr int endBits = 24;
  static constexpr std::size_t mostEnds = std::size_t(1) << endBits;
  static constexpr std::uint64_t endMask = mostEnds - 1;
  static constexpr std::uint64_t nextColumn = std::uint64_t(1) << endBits;
  static constexpr std::uint64_t nextRow = nextColumn << cellBits;
  static constexpr std::size_t mostInRow = 64;   ///< of the ends in three cells of a row
  static constexpr float farthest = 500'000.0f;  // cells from the picture's corner

  static std::uint64_t key(int row, int column, std::size_t end) {
    constexpr int middle = 1 << (cellBits - 1);
    return std::uint64_t(row + middle) * nextRow + std::uint64_t(column + middle) * nextColumn +
           std::uint64_t(end);
  }

  std::vector<std::uint64_t> m_order;  ///< see `key`
};

/// Returns the pairs of ends that continue each other, nearest first.
std::vector<Pair> pairsOf(const std::vector<LineEnd>& ends, const std::vector<Segment>& segments,
                          const PictureView& view) {
  const float unit = view.outputUnit();
  const float reach = widestGap * unit;
  std::vector<Pair> pairs;
  EndGrid(ends, reach).forEachPair([&](std::size_t i, std::size_t k, std::uint64_t place) {
    // A crumb is no ring.
    if (ends[k].chain == ends[i].chain && ends[i].links < fewestOfRing)
      return;
    const glm::vec2 way = ends[k].pixel - ends[i].pixel;
    if (!goesOnIn(ends[i].direction, ends[k].direction, way, unit))
      return;
    const float apart = glm::distance(placeOf(segments, ends[k]), placeOf(segments, ends[i]));
    const float mm = view.millimetresPerPixel(placeOf(segments, ends[i]));
    if (!(apart > depthShare * reach * mm))
      pairs.push_back({glm::length(way), k, i, place});
  });
  std::sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
    return std::tie(a.distance, a.b, a.place) < std::tie(b.distance, b.b, b.place);
  });
  return pairs;
}

Segment bridgeBetween(const std::vector<Segment>& segments, const LineEnd& from,
                      const LineEnd& to) {
  const Segment& a = segments[from.segment];
  const Segment& b = segments[to.segment];
  return {.a = placeOf(segments, from),
          .b = placeOf(segments, to),
          .normalA = from.atB ? a.normalB : a.normalA,
          .normalB = to.atB ? b.normalB : b.normalA,
          .opacityA = from.atB ? a.opacityB : a.opacityA,
          .opacityB = to.atB ? b.opacityB : b.opacityA,
          .entryA = from.atB ? a.entryB : a.entryA,
          .entryB = to.atB ? b.entryB : b.entryA,
          .gammaA = from.atB ? a.gammaB : a.gammaA,
          .gammaB = to.atB ? b.gammaB : b.gammaA,
          .triangle = a.triangle};
}

/// Puts chains together at their ends. End 2i is the beginning of chain i, end 2i + 1 its end.
class ChainLinker {
 public:
  ChainLinker(const Chains& chains, const ChainPoints& points)
      : m_chains(chains),
        m_points(points),
        m_next(2 * chains.count(), none),
        m_bridges(2 * chains.count(), none) {}

  /// Returns false where one of the ends has been joined already.
  bool join(const LineEnd& a, const LineEnd& b) {
    const std::size_t from = indexOf(a);
    const std::size_t to = indexOf(b);
    if (m_next[from] != none || m_next[to] != none || from == to)
      return false;
    m_next[from] = to;
    m_next[to] = from;
    return true;
  }
  /// Lays a segment between two ends that were joined; its a lies at the first.
  void bridge(const LineEnd& a, std::uint32_t segment, const LineEnd& b) {
    m_bridges[indexOf(a)] = 2 * std::size_t(segment);
    m_bridges[indexOf(b)] = 2 * std::size_t(segment) + 1;
  }

  DrawnChains take() {
    m_taken.resize(m_chains.count());
    m_joined.chains.links.reserve(m_chains.links.size() + m_chains.count());
    m_joined.points.points.reserve(m_points.points.size());
    for (std::size_t end = 0; end < m_next.size(); ++end)
      if (m_next[end] == none && !m_taken[end / 2])
        walk(end);
    for (std::size_t chain = 0; chain < m_taken.size(); ++chain)
      if (!m_taken[chain])
        walk(2 * chain);
    m_joined.chains.first.push_back(std::uint32_t(m_joined.chains.links.size()));
    return std::move(m_joined);
  }

 private:
  static constexpr std::size_t none = ~std::size_t(0);

  static std::size_t indexOf(const LineEnd& end) { return 2 * end.chain + (end.last ? 1 : 0); }

  /// Follows the line from that end of its first chain.
  void walk(std::size_t beginning) {
    std::vector<Chains::Link>& links = m_joined.chains.links;
    std::vector<ChainPoints::Point>& points = m_joined.points.points;
    m_joined.chains.first.push_back(std::uint32_t(links.size()));
    const std::size_t first = points.size();
    float length = 0.0f;
    bool bridged = false;
    for (std::size_t end = beginning; end != none && !m_taken[end / 2];) {
      const std::size_t chain = end / 2;
      const bool reversed = end % 2 == 1;
      m_taken[chain] = true;
      const std::span<const ChainPoints::Point> own = m_points.of(m_chains, chain);
      for (std::size_t i = 0; i + 1 < own.size(); ++i) {
        Chains::Link link =
            m_chains.links[m_chains.first[chain] + (reversed ? own.size() - 2 - i : i)];
        link.reversed = link.reversed != reversed;
        links.push_back(link);
      }
      const ChainPoints::Point& start = reversed ? own.back() : own.front();
      if (bridged)
        length += glm::distance(points.back().pixel, start.pixel);
      // Without a bridge it is where the chain before ends.
      if (bridged || points.size() == first)
        points.push_back(start);
      for (std::size_t i = 1; i < own.size(); ++i)
        points.push_back(own[reversed ? own.size() - 1 - i : i]);
      length += m_points.lengths[chain];
      const std::size_t out = end ^ 1u;
      bridged = m_bridges[out] != none;
      if (bridged)
        links.push_back({std::uint32_t(m_bridges[out] / 2), m_bridges[out] % 2 == 1});
      end = m_next[out];
    }
    if (bridged) {
      const ChainPoints::Point start = points[first];
      length += glm::distance(points.back().pixel, start.pixel);
      points.push_back(start);
    }
    m_joined.points.lengths.push_back(length);
  }

  const Chains& m_chains;
  const ChainPoints& m_points;
  std::vector<std::size_t> m_next;     ///< the end that each goes on to
  std::vector<std::size_t> m_bridges;  ///< twice the segment between, one more where its b is there
  std::vector<bool> m_taken;
  DrawnChains m_joined;
};

}  // namespace

DrawnChains joinedChains(std::vector<Segment>& segments, const PictureView& view) {
  const Chains chains = connectedChains(segments);
  const ChainPoints points = pointsInPicture(chains, segments, view);
  const std::vector<LineEnd> ends = EndFinder(chains, points, view).ends(segments);
  ChainLinker linker(chains, points);
  for (const Pair& pair : pairsOf(ends, segments, view)) {
    const LineEnd& a = ends[pair.a];
    const LineEnd& b = ends[pair.b];
    if (!linker.join(a, b) || placeOf(segments, a) == placeOf(segments, b))
      continue;
    linker.bridge(a, std::uint32_t(segments.size()), b);
    segments.push_back(bridgeBetween(segments, a, b));
  }
  return linker.take();
}

}  // namespace sline::render
