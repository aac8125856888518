// SPDX-License-Identifier: Apache-2.0
#include "render/vectors/crumbs.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <utility>

#include "render/strokes/continuation.h"

namespace sline::render {

namespace {

// λ over which an end's direction is taken.
constexpr float directionReach = 3.0f;
// Strokes that are veiled this much alike are one.
constexpr float sameVeil = 0.03f;

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

struct Joint {
  float distance;
  std::size_t a;  ///< of the ends
  std::size_t b;
};

/// Returns the pairs of ends by which strokes continue each other, nearest first.
std::vector<Joint> joints(const std::vector<StrokeEnd>& ends, float unit) {
  std::map<std::pair<int, int>, std::vector<std::size_t>> cells;
  std::vector<Joint> found;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const int column = int(std::floor(ends[i].at.x / (widestGap * unit)));
    const int row = int(std::floor(ends[i].at.y / (widestGap * unit)));
    for (int y = row - 1; y <= row + 1; ++y)
      for (int x = column - 1; x <= column + 1; ++x)
        if (const auto cell = cells.find({x, y}); cell != cells.end())
          for (const std::size_t k : cell->second)
            if (ends[k].stroke != ends[i].stroke &&
                goesOnIn(ends[k].direction, ends[i].direction, ends[i].at - ends[k].at, unit))
              found.push_back({glm::distance(ends[k].at, ends[i].at), k, i});
    cells[{column, row}].push_back(i);
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
    std::vector<StrokeEnd> ends;
    for (std::size_t i = 0; i < m_strokes.size(); ++i)
      if (!m_strokes[i].closed && !m_strokes[i].points.empty())
        for (const bool atBack : {false, true})
          ends.push_back(endOf(m_strokes[i], i, atBack, directionReach * unit));
    m_continued.resize(m_strokes.size());
    for (const Joint& joint : joints(ends, unit)) {
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

}  // namespace

std::vector<VisibleStroke> withoutCrumbs(std::vector<VisibleStroke> strokes, float outputUnit,
                                         float shortest) {
  if (strokes.empty())
    return strokes;
  std::vector<Joiner::Joined> joined = Joiner(std::move(strokes), outputUnit).take();
  float longest = 0.0f;
  for (const Joiner::Joined& one : joined)
    longest = std::max(longest, lengthOf(one.stroke));
  const float least = std::min(shortest * outputUnit, longest);
  std::vector<VisibleStroke> kept;
  kept.reserve(joined.size());
  for (Joiner::Joined& one : joined)
    if (one.stroke.closed || one.continued || lengthOf(one.stroke) >= least)
      kept.push_back(std::move(one.stroke));
  return kept;
}

}  // namespace sline::render
