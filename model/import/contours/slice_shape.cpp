// SPDX-License-Identifier: Apache-2.0
#include "model/import/contours/slice_shape.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace sline::model {

namespace {

constexpr std::uint32_t noSegment = 0xffffffffu;
constexpr float farAway = std::numeric_limits<float>::max();

using OutlineEdge = std::array<glm::dvec2, 2>;

float squaredDistance(const OutlineEdge& segment, const glm::dvec2& p) {
  const glm::dvec2 way = segment[1] - segment[0];
  const double length = glm::dot(way, way);
  const double t =
      length > 0.0 ? std::clamp(glm::dot(p - segment[0], way) / length, 0.0, 1.0) : 0.0;
  const glm::dvec2 off = p - (segment[0] + t * way);
  return float(glm::dot(off, off));
}

/// Finds the nearest segment of each sample, from samples beside segments outwards.
class NearestSegments {
 public:
  NearestSegments(const std::vector<OutlineEdge>& segments, const PlaneGrid& grid)
      : m_segments(segments), m_grid(grid), m_squared(grid.size(), farAway) {
    m_nearest.assign(grid.size(), noSegment);
  }

  /// Offers the segment to the samples around it.
  void seed(std::uint32_t index) {
    const OutlineEdge& segment = m_segments[index];
    const double length = glm::length(segment[1] - segment[0]);
    const int steps = int(length / m_grid.cell) + 1;
    for (int i = 0; i <= steps; ++i) {
      const glm::dvec2 p = segment[0] + (double(i) / double(steps)) * (segment[1] - segment[0]);
      const glm::dvec2 at = (p - m_grid.origin) / m_grid.cell;
      const int column = int(std::floor(at.x));
      const int row = int(std::floor(at.y));
      for (int y = std::max(row - 1, 0); y <= std::min(row + 2, m_grid.rows - 1); ++y)
        for (int x = std::max(column - 1, 0); x <= std::min(column + 2, m_grid.columns - 1); ++x)
          offer(x, y, index);
    }
  }

  /// Passes segments on: with each row both ways, first down, then up.
  void spread() {
    for (int y = 0; y < m_grid.rows; ++y)
      spreadRow(y, y - 1);
    for (int y = m_grid.rows - 1; y >= 0; --y)
      spreadRow(y, y + 1);
  }

  const std::vector<std::uint32_t>& nearest() const { return m_nearest; }
  const std::vector<float>& squared() const { return m_squared; }

 private:
  std::size_t at(int x, int y) const {
    return std::size_t(y) * std::size_t(m_grid.columns) + std::size_t(x);
  }
  void offer(int x, int y, std::uint32_t index) {
    const std::size_t here = at(x, y);
    if (index == noSegment || index == m_nearest[here])
      return;
    const glm::dvec2 p = m_grid.origin + m_grid.cell * glm::dvec2(x, y);
    const float squared = squaredDistance(m_segments[index], p);
    if (squared < m_squared[here]) {
      m_squared[here] = squared;
      m_nearest[here] = index;
    }
  }
  void spreadRow(int y, int from) {
    const int last = m_grid.columns - 1;
    if (from >= 0 && from < m_grid.rows)
      for (int x = 0; x <= last; ++x)
        for (int dx = std::max(x - 1, 0); dx <= std::min(x + 1, last); ++dx)
          offer(x, y, m_nearest[at(dx, from)]);
    for (int x = 1; x <= last; ++x)
      offer(x, y, m_nearest[at(x - 1, y)]);
    for (int x = last - 1; x >= 0; --x)
      offer(x, y, m_nearest[at(x + 1, y)]);
  }

  const std::vector<OutlineEdge>& m_segments;
  PlaneGrid m_grid;
  std::vector<float> m_squared;
  std::vector<std::uint32_t> m_nearest;
};

}  // namespace

SliceShape::SliceShape(const SliceOutline& outline, const PlaneGrid& grid)
    : m_outline(&outline), m_grid(grid) {
  fill();
  numberPieces();
  NearestSegments near(outline.edges, grid);
  for (std::uint32_t i = 0; i < outline.edges.size(); ++i)
    near.seed(i);
  near.spread();
  m_distances.resize(grid.size());
  for (std::size_t i = 0; i < grid.size(); ++i)
    m_distances[i] = std::sqrt(near.squared()[i]) * (m_pieces[i] != 0 ? -1.0f : 1.0f);
  // A segment belongs to the piece of the sample to which it is nearest; such a sample lies beside
  // it.
  m_pieceOfSegment.assign(outline.edges.size(), 0);
  std::vector<float> closest(outline.edges.size(), farAway);
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const std::uint32_t segment = near.nearest()[i];
    if (m_pieces[i] != 0 && segment != noSegment && near.squared()[i] < closest[segment]) {
      closest[segment] = near.squared()[i];
      m_pieceOfSegment[segment] = m_pieces[i];
    }
  }
}

std::vector<float> SliceShape::distancesTo(const std::vector<char>& chosen,
                                           std::vector<std::uint32_t>* nearest) const {
  NearestSegments near(m_outline->edges, m_grid);
  for (std::uint32_t i = 0; i < m_pieceOfSegment.size(); ++i)
    if (m_pieceOfSegment[i] != 0 && chosen[m_pieceOfSegment[i]] != 0)
      near.seed(i);
  near.spread();
  std::vector<float> distances(m_grid.size());
  if (nearest)
    nearest->assign(m_grid.size(), 0);
  for (std::size_t i = 0; i < distances.size(); ++i) {
    const bool inside = m_pieces[i] != 0 && chosen[m_pieces[i]] != 0;
    distances[i] = std::sqrt(near.squared()[i]) * (inside ? -1.0f : 1.0f);
    const std::uint32_t segment = near.nearest()[i];
    if (nearest && segment != noSegment)
      (*nearest)[i] = inside ? m_pieces[i] : m_pieceOfSegment[segment];
  }
  return distances;
}

/// Marks samples within an odd number of outlines, row by row. A point on a row counts as above it,
/// so that rows through corners count each outline once.
void SliceShape::fill() {
  std::vector<std::vector<float>> crossings(std::size_t(m_grid.rows));
  for (const OutlineEdge& segment : m_outline->edges) {
    glm::dvec2 a = (segment[0] - m_grid.origin) / m_grid.cell;
    glm::dvec2 b = (segment[1] - m_grid.origin) / m_grid.cell;
    if (a.y > b.y)
      std::swap(a, b);
    const int first = std::max(int(std::ceil(a.y)), 0);
    for (int row = first; row < m_grid.rows && double(row) < b.y; ++row)
      crossings[std::size_t(row)].push_back(
          float(a.x + (double(row) - a.y) / (b.y - a.y) * (b.x - a.x)));
  }
  m_inside.assign(m_grid.size(), 0);
  for (int row = 0; row < m_grid.rows; ++row) {
    std::vector<float>& here = crossings[std::size_t(row)];
    std::sort(here.begin(), here.end());
    for (std::size_t i = 0; i + 1 < here.size(); i += 2) {
      const int begin = std::max(int(std::ceil(here[i])), 0);
      for (int x = begin; x < m_grid.columns && float(x) < here[i + 1]; ++x)
        m_inside[std::size_t(row) * std::size_t(m_grid.columns) + std::size_t(x)] = 1;
    }
  }
}

void SliceShape::numberPieces() {
  m_pieces.assign(m_grid.size(), 0);
  std::vector<std::size_t> open;
  const auto columns = std::size_t(m_grid.columns);
  const auto visit = [&](std::size_t i) {
    if (m_inside[i] != 0 && m_pieces[i] == 0) {
      m_pieces[i] = m_pieceCount;
      open.push_back(i);
    }
  };
  for (std::size_t start = 0; start < m_grid.size(); ++start) {
    if (m_inside[start] == 0 || m_pieces[start] != 0)
      continue;
    ++m_pieceCount;
    visit(start);
    while (!open.empty()) {
      const std::size_t i = open.back();
      open.pop_back();
      if (i % columns > 0)
        visit(i - 1);
      if (i % columns + 1 < columns)
        visit(i + 1);
      if (i >= columns)
        visit(i - columns);
      if (i + columns < m_grid.size())
        visit(i + columns);
    }
  }
}

}  // namespace sline::model
