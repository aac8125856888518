// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
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
  EndFinder(const std::vector<Segment>& segments, const Chains& chains, const PictureView& view)
      : m_segments(segments), m_chains(chains), m_view(view) {}

  std::vector<LineEnd> ends() const {
    std::vector<LineEnd> found;
    for (std::size_t chain = 0; chain < m_chains.count(); ++chain) {
      const std::size_t first = m_chains.first[chain];
      const std::size_t last = m_chains.first[chain + 1] - 1;
      if (point(first, false) == point(last, true) && last > first)
        continue;  // closed
      add(chain, first, false, found);
      add(chain, last, true, found);
    }
    return found;
  }

 private:
  const glm::vec3& point(std::size_t link, bool atEnd) const {
    const Chains::Link& l = m_chains.links[link];
    const Segment& s = m_segments[l.segment];
    return atEnd != l.reversed ? s.b : s.a;
  }

  void add(std::size_t chain, std::size_t link, bool atEnd, std::vector<LineEnd>& found) const {
    const auto at = m_view.project(point(link, atEnd));
    if (!(at.w > 0.0f))
      return;
    const std::size_t first = m_chains.first[chain];
    const std::size_t last = m_chains.first[chain + 1] - 1;
    glm::vec2 inner = at.pixel;
    for (std::size_t i = link;; i = atEnd ? i - 1 : i + 1) {
      inner = m_view.project(point(i, !atEnd)).pixel;
      if (glm::distance(inner, at.pixel) > directionReach * m_view.outputUnit() ||
          i == (atEnd ? first : last))
        break;
    }
    const float length = glm::distance(inner, at.pixel);
    if (!(length > 0.0f) || !std::isfinite(length))
      return;
    const Chains::Link& l = m_chains.links[link];
    found.push_back({chain, l.segment, atEnd != l.reversed, atEnd, at.pixel,
                     (at.pixel - inner) / length, last + 1 - first});
  }

  const std::vector<Segment>& m_segments;
  const Chains& m_chains;
  const PictureView& m_view;
};

struct Pair {
  float distance;
  std::size_t a;
  std::size_t b;
};

/// Finds ends that lie near each other in the picture, by cells as wide as their reach.
class EndGrid {
 public:
  EndGrid(const std::vector<LineEnd>& ends, float reach) : m_cells(ends.size()) {
    m_order.reserve(ends.size());
    for (std::size_t i = 0; i < ends.size(); ++i) {
      if (glm::length(ends[i].pixel) > 1e6f)
        continue;
      m_cells[i] = {int(std::floor(ends[i].pixel.x / reach)),
                    int(std::floor(ends[i].pixel.y / reach)), true};
      m_order.push_back(std::uint32_t(i));
    }
    std::sort(m_order.begin(), m_order.end(),
              [this](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  }

  /// Calls `body` for each earlier end in the cells around that of end `i`.
  template <class Body>
  void forEachAround(std::size_t i, const Body& body) const {
    const Cell& cell = m_cells[i];
    if (!cell.known)
      return;
    for (int row = cell.row - 1; row <= cell.row + 1; ++row) {
      auto at = std::lower_bound(m_order.begin(), m_order.end(), Key(row, cell.column - 1, 0),
                                 [this](std::uint32_t a, const Key& k) { return key(a) < k; });
      for (; at != m_order.end() && key(*at) < Key(row, cell.column + 2, 0); ++at)
        if (*at < i)
          body(*at);
    }
  }

 private:
  using Key = std::tuple<int, int, std::uint32_t>;
  struct Cell {
    int column = 0;
    int row = 0;
    bool known = false;  ///< not too far outside the picture
  };
  Key key(std::uint32_t i) const { return {m_cells[i].row, m_cells[i].column, i}; }

  std::vector<Cell> m_cells;           ///< of each end
  std::vector<std::uint32_t> m_order;  ///< the ends, by row, column and their own order
};

/// Returns the pairs of ends that continue each other, nearest first.
std::vector<Pair> pairsOf(const std::vector<LineEnd>& ends, const std::vector<Segment>& segments,
                          const PictureView& view) {
  const float unit = view.outputUnit();
  const float reach = widestGap * unit;
  const EndGrid grid(ends, reach);
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < ends.size(); ++i)
    grid.forEachAround(i, [&](std::size_t k) {
      // A crumb is no ring.
      if (ends[k].chain == ends[i].chain && ends[i].links < fewestOfRing)
        return;
      const glm::vec2 way = ends[k].pixel - ends[i].pixel;
      const float distance = glm::length(way);
      const float apart = glm::distance(placeOf(segments, ends[k]), placeOf(segments, ends[i]));
      const float mm = view.millimetresPerPixel(placeOf(segments, ends[i]));
      if (!goesOnIn(ends[i].direction, ends[k].direction, way, unit) ||
          apart > depthShare * reach * mm)
        return;
      pairs.push_back({distance, k, i});
    });
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Pair& a, const Pair& b) { return a.distance < b.distance; });
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
  explicit ChainLinker(const Chains& chains)
      : m_chains(chains), m_next(2 * chains.count(), none), m_bridges(2 * chains.count(), none) {}

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

  Chains take() {
    m_taken.resize(m_chains.count());
    for (std::size_t end = 0; end < m_next.size(); ++end)
      if (m_next[end] == none && !m_taken[end / 2])
        walk(end);
    for (std::size_t chain = 0; chain < m_taken.size(); ++chain)
      if (!m_taken[chain])
        walk(2 * chain);
    m_joined.first.push_back(std::uint32_t(m_joined.links.size()));
    return std::move(m_joined);
  }

 private:
  static constexpr std::size_t none = ~std::size_t(0);

  static std::size_t indexOf(const LineEnd& end) { return 2 * end.chain + (end.last ? 1 : 0); }

  /// Follows the line from that end of its first chain.
  void walk(std::size_t start) {
    m_joined.first.push_back(std::uint32_t(m_joined.links.size()));
    for (std::size_t end = start; end != none && !m_taken[end / 2];) {
      const std::size_t chain = end / 2;
      m_taken[chain] = true;
      const std::uint32_t first = m_chains.first[chain];
      const std::uint32_t last = m_chains.first[chain + 1];
      for (std::uint32_t i = first; i < last; ++i) {
        Chains::Link link = m_chains.links[end % 2 == 0 ? i : last - 1 - (i - first)];
        link.reversed = link.reversed != (end % 2 == 1);
        m_joined.links.push_back(link);
      }
      const std::size_t out = end ^ 1u;
      if (const std::size_t bridge = m_bridges[out]; bridge != none)
        m_joined.links.push_back({std::uint32_t(bridge / 2), bridge % 2 == 1});
      end = m_next[out];
    }
  }

  const Chains& m_chains;
  std::vector<std::size_t> m_next;     ///< the end that each goes on to
  std::vector<std::size_t> m_bridges;  ///< twice the segment between, one more where its b is there
  std::vector<bool> m_taken;
  Chains m_joined;
};

}  // namespace

Chains joinedChains(std::vector<Segment>& segments, const PictureView& view) {
  const Chains chains = connectedChains(segments);
  const std::vector<LineEnd> ends = EndFinder(segments, chains, view).ends();
  ChainLinker linker(chains);
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
