// SPDX-License-Identifier: Apache-2.0
#include "render/vectors/crumbs.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>
#include <utility>

namespace sline::render {

namespace {

constexpr float shortest = 8.0f;  // λ
constexpr float reach = 2.0f;     // λ

float lengthOf(const VisibleStroke& stroke) {
  float length = 0.0f;
  for (std::size_t i = 1; i < stroke.points.size(); ++i)
    length += glm::distance(stroke.points[i - 1].at, stroke.points[i].at);
  return length;
}

/// Joins strokes of which an end lies near an end of another.
class Joints {
 public:
  Joints(const std::vector<VisibleStroke>& strokes, float distance)
      : m_distance(distance), m_root(strokes.size()) {
    std::iota(m_root.begin(), m_root.end(), std::size_t(0));
    for (std::size_t i = 0; i < strokes.size(); ++i)
      if (!strokes[i].points.empty())
        for (const StrokePoint* end : {&strokes[i].points.front(), &strokes[i].points.back()})
          enter(i, end->at);
  }

  std::size_t rootOf(std::size_t i) {
    while (m_root[i] != i)
      i = m_root[i] = m_root[m_root[i]];
    return i;
  }

 private:
  void enter(std::size_t stroke, const glm::vec2& end) {
    const int column = int(std::floor(end.x / m_distance));
    const int row = int(std::floor(end.y / m_distance));
    for (int y = row - 1; y <= row + 1; ++y)
      for (int x = column - 1; x <= column + 1; ++x)
        if (const auto cell = m_cells.find({x, y}); cell != m_cells.end())
          for (const auto& [other, place] : cell->second)
            if (glm::distance(place, end) <= m_distance)
              m_root[rootOf(stroke)] = rootOf(other);
    m_cells[{column, row}].emplace_back(stroke, end);
  }

  float m_distance;
  std::vector<std::size_t> m_root;
  std::map<std::pair<int, int>, std::vector<std::pair<std::size_t, glm::vec2>>> m_cells;
};

}  // namespace

std::vector<VisibleStroke> withoutCrumbs(std::vector<VisibleStroke> strokes, float outputUnit) {
  if (strokes.empty())
    return strokes;
  Joints joints(strokes, reach * outputUnit);
  std::vector<float> lengths(strokes.size(), 0.0f);
  for (std::size_t i = 0; i < strokes.size(); ++i)
    lengths[joints.rootOf(i)] += lengthOf(strokes[i]);
  const float longest = *std::max_element(lengths.begin(), lengths.end());
  const float least = std::min(shortest * outputUnit, longest);
  std::vector<VisibleStroke> kept;
  kept.reserve(strokes.size());
  for (std::size_t i = 0; i < strokes.size(); ++i)
    if (strokes[i].closed || lengths[joints.rootOf(i)] >= least)
      kept.push_back(std::move(strokes[i]));
  return kept;
}

}  // namespace sline::render
