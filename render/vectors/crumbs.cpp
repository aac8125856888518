// SPDX-License-Identifier: Apache-2.0
#include "render/vectors/crumbs.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>
#include <utility>

#include "render/strokes/continuation.h"

namespace sline::render {

namespace {

// λ over which an end's direction is taken.
constexpr float directionReach = 3.0f;
// Pieces of so much of the shortest length stay in a row of so many of it.
constexpr float leastOfRow = 0.6f;
constexpr float leastRow = 2.0f;
// Strokes that are veiled this much alike are one.
constexpr float sameVeil = 0.03f;
// Where thousands of strokes end in one place, so many of them are looked at for each.
constexpr std::size_t mostInCell = 128;

float lengthOf(const VisibleStroke& stroke) {
  float length = 0.0f;
  for (std::size_t i = 1; i < stroke.points.size(); ++i)
    length += glm::distance(stroke.points[i - 1].at, stroke.points[i].at);
  return length;
}

struct StrokeEnd {
  std::size_t stroke;
  bool atBack;
  glm::vec2 at;
  glm::vec2 direction;  ///< away from the stroke; 0 for a dot
};

StrokeEnd endOf(const VisibleStroke& stroke, std::size_t index, bool atBack, float way) {
  const auto point = [&](std::size_t i) {
    return stroke.points[atBack ? stroke.points.size() - 1 - i : i].at;
  };
  std::size_t i = 1;
  while (i + 1 < stroke.points.size() && glm::distance(point(i), point(0)) < way)
    ++i;
  const glm::vec2 inner = i < stroke.points.size() ? point(i) : point(0);
  const float length = glm::distance(point(0), inner);
  return {index, atBack, point(0), length > 0.0f ? (point(0) - inner) / length : glm::vec2(0.0f)};
}

std::vector<StrokeEnd> endsOf(const std::vector<VisibleStroke>& strokes, float unit) {
  std::vector<StrokeEnd> ends;
  for (std::size_t i = 0; i < strokes.size(); ++i)
    if (!strokes[i].closed && !strokes[i].points.empty())
      for (const bool atBack : {false, true})
        ends.push_back(endOf(strokes[i], i, atBack, directionReach * unit));
  return ends;
}

struct Joint {
  float distance;
  std::size_t a;  ///< of the ends
  std::size_t b;
};

/// Returns the pairs of ends by which strokes continue each other over gaps of up to `widest` λ,
/// nearest first.
std::vector<Joint> joints(const std::vector<StrokeEnd>& ends, float unit, float widest) {
  std::map<std::pair<int, int>, std::vector<std::size_t>> cells;
  std::vector<Joint> found;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const int column = int(std::floor(ends[i].at.x / (widest * unit)));
    const int row = int(std::floor(ends[i].at.y / (widest * unit)));
    for (int y = row - 1; y <= row + 1; ++y)
      for (int x = column - 1; x <= column + 1; ++x)
        if (const auto cell = cells.find({x, y}); cell != cells.end())
          for (const std::size_t k : cell->second)
            if (ends[k].stroke != ends[i].stroke && goesOnIn(ends[k].direction, ends[i].direction,
                                                             ends[i].at - ends[k].at, unit, widest))
              found.push_back({glm::distance(ends[k].at, ends[i].at), k, i});
    if (std::vector<std::size_t>& own = cells[{column, row}]; own.size() < mostInCell)
      own.push_back(i);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Joint& a, const Joint& b) { return a.distance < b.distance; });
  return found;
}

bool alike(const Veil& a, const Veil& b) {
  return std::abs(a.transmittance - b.transmittance) < sameVeil &&
         glm::distance(a.colour, b.colour) < sameVeil;
}

/// Draws strokes that continue each other in one go; `next` and `marks` tell what follows each end.
class Joiner {
 public:
  Joiner(std::vector<VisibleStroke> strokes, float unit)
      : m_strokes(std::move(strokes)), m_next(2 * m_strokes.size(), none) {
    const std::vector<StrokeEnd> ends = endsOf(m_strokes, unit);
    m_continued.resize(m_strokes.size());
    for (const Joint& joint : joints(ends, unit, widestGap)) {
      const StrokeEnd& a = ends[joint.a];
      const StrokeEnd& b = ends[joint.b];
      const std::size_t from = 2 * a.stroke + (a.atBack ? 1 : 0);
      const std::size_t to = 2 * b.stroke + (b.atBack ? 1 : 0);
      if (m_next[from] != none || m_next[to] != none)
        continue;
      if (!alike(m_strokes[a.stroke].veil, m_strokes[b.stroke].veil)) {
        m_continued[a.stroke] = m_continued[b.stroke] = true;
        continue;
      }
      m_next[from] = to;
      m_next[to] = from;
    }
  }

  struct Joined {
    VisibleStroke stroke;
    bool continued = false;  ///< by one that is veiled otherwise
  };

  std::vector<Joined> take() {
    std::vector<Joined> all;
    m_taken.resize(m_strokes.size());
    for (std::size_t end = 0; end < m_next.size(); ++end)
      if (m_next[end] == none && !m_taken[end / 2])
        all.push_back(walk(end));
    for (std::size_t i = 0; i < m_strokes.size(); ++i)
      if (!m_taken[i]) {
        all.push_back(walk(2 * i));
        all.back().stroke.closed = true;
      }
    return all;
  }

 private:
  static constexpr std::size_t none = ~std::size_t(0);

  /// Follows the line from that end of its first stroke.
  Joined walk(std::size_t start) {
    Joined joined;
    joined.stroke.closed = m_strokes[start / 2].closed;
    joined.stroke.veil = m_strokes[start / 2].veil;
    for (std::size_t end = start; end != none && !m_taken[end / 2]; end = m_next[end ^ 1u]) {
      m_taken[end / 2] = true;
      joined.continued = joined.continued || m_continued[end / 2];
      std::vector<StrokePoint>& points = m_strokes[end / 2].points;
      if (end % 2 == 1)
        std::reverse(points.begin(), points.end());
      joined.stroke.points.insert(joined.stroke.points.end(), points.begin(), points.end());
    }
    return joined;
  }

  std::vector<VisibleStroke> m_strokes;
  std::vector<std::size_t> m_next;  ///< the end that goes on from each: 2i a stroke's front, 2i + 1
                                    ///< its back
  std::vector<bool> m_continued;
  std::vector<bool> m_taken;
};

/// Returns for each stroke the length of all that lie in a row with it, with gaps shorter than a
/// crumb: what is left of one line where another surface comes to the front now and then.
std::vector<float> rowLengths(const std::vector<VisibleStroke>& strokes, float unit,
                              float shortest) {
  const std::vector<StrokeEnd> ends = endsOf(strokes, unit);
  std::vector<std::size_t> row(strokes.size());
  std::iota(row.begin(), row.end(), std::size_t(0));
  const auto rowOf = [&row](std::size_t i) {
    while (row[i] != i)
      i = row[i] = row[row[i]];
    return i;
  };
  std::vector<bool> joined(ends.size());
  for (const Joint& joint : joints(ends, unit, std::max(shortest, widestGap))) {
    if (joined[joint.a] || joined[joint.b])
      continue;
    joined[joint.a] = joined[joint.b] = true;
    row[rowOf(ends[joint.a].stroke)] = rowOf(ends[joint.b].stroke);
  }
  std::vector<float> lengths(strokes.size());
  for (std::size_t i = 0; i < strokes.size(); ++i)
    lengths[rowOf(i)] += lengthOf(strokes[i]);
  for (std::size_t i = 0; i < strokes.size(); ++i)
    lengths[i] = lengths[rowOf(i)];
  return lengths;
}

}  // namespace

std::vector<VisibleStroke> withoutCrumbs(std::vector<VisibleStroke> strokes, float outputUnit,
                                         float shortest) {
  if (strokes.empty())
    return strokes;
  std::vector<bool> continued;
  std::vector<VisibleStroke> all;
  for (Joiner::Joined& one : Joiner(std::move(strokes), outputUnit).take()) {
    continued.push_back(one.continued);
    all.push_back(std::move(one.stroke));
  }
  float longest = 0.0f;
  for (const VisibleStroke& stroke : all)
    longest = std::max(longest, lengthOf(stroke));
  const float least = std::min(shortest * outputUnit, longest);
  const std::vector<float> rows = rowLengths(all, outputUnit, shortest);
  std::vector<VisibleStroke> kept;
  kept.reserve(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const float length = lengthOf(all[i]);
    if (all[i].closed || continued[i] || length >= least ||
        (length >= leastOfRow * least && rows[i] >= leastRow * least))
      kept.push_back(std::move(all[i]));
  }
  return kept;
}

}  // namespace sline::render
