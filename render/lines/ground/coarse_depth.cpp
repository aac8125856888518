// SPDX-License-Identifier: Apache-2.0
#include "render/lines/ground/coarse_depth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include "model/base/wide_loops.h"
#include "render/lines/ground/view_fields.h"

namespace sline::render {

namespace {
constexpr float finestCell = 6.0f;  // λ
constexpr float mostCells = 256.0f;
// The share of F by which an obstacle must lie in front of what it hides.
constexpr float clearly = 0.05f;
// Places farther than this from the middle of the picture are ignored, λ.
constexpr float farthest = 4000.0f;

constexpr std::size_t placesOfBlock = 256;

/// In which cells places lie, −1 for none, and how far they are from the eye's plane, mm.
struct CellBlock {
  std::array<std::int32_t, placesOfBlock> cell;
  std::array<float, placesOfBlock> distance;
};

struct CellGrid {
  ViewScale::Frame frame;
  glm::vec2 low;  ///< λ
  float perSide;
  int columns;
  int rows;
};

SLINE_WIDE_LOOPS
void findCells(std::span<const glm::vec3> places, const CellGrid& grid, bool atInfinity,
               CellBlock& out) {
  const ViewScale::Frame frame = grid.frame;
  const int rowLength = grid.columns;
  const float lastColumn = std::nextafter(float(grid.columns), 0.0f);
  const float lastRow = std::nextafter(float(grid.rows), 0.0f);
  const glm::vec2 low = grid.low;
  const float perSide = grid.perSide;
  const glm::vec3* in = places.data();
  const float least = atInfinity ? frame.unit : 0.0f;
  const float perDistance = atInfinity ? 0.0f : frame.unit;
  const std::size_t count = places.size();
  SLINE_INDEPENDENT_ROUNDS
  for (std::size_t i = 0; i < count; ++i) {
    const float dx = in[i].x - frame.origin.x;
    const float dy = in[i].y - frame.origin.y;
    const float dz = in[i].z - frame.origin.z;
    const float distance = -(dx * frame.back.x + dy * frame.back.y + dz * frame.back.z);
    const float mm = least + distance * perDistance;
    const float perMm = mm > 0.0f ? 1.0f / mm : 0.0f;
    const float x = perMm * (dx * frame.right.x + dy * frame.right.y + dz * frame.right.z);
    const float y = perMm * (dx * frame.up.x + dy * frame.up.y + dz * frame.up.z);
    const float column = (x - low.x) * perSide;
    const float row = (y - low.y) * perSide;
    // In this order of arguments what is no number is 0.
    const float seenColumn = std::min(std::max(0.0f, column), lastColumn);
    const float seenRow = std::min(std::max(0.0f, row), lastRow);
    const float beyond = std::abs(column - seenColumn) + std::abs(row - seenRow);
    const int cell = int(seenRow) * rowLength + int(seenColumn);
    out.cell[i] = (mm > 0.0f ? beyond : 1.0f) <= 0.0f ? cell : -1;
    out.distance[i] = distance;
  }
}
}  // namespace

CoarseDepth::CoarseDepth(const model::Surface& surface, const model::Camera& camera)
    : m_scale(camera), m_slack(clearly * surface.featureSize) {
  const ViewScale::Point middle = m_scale.project(surface.boundingSphere.centre);
  const float radius =
      std::clamp(surface.boundingSphere.radius * middle.perMm * 1.2f, 1.0f, farthest);
  m_side =
      std::max({finestCell, 1.5f * surface.meanEdge * middle.perMm, 2.0f * radius / mostCells});
  m_low = glm::clamp(middle.at, -farthest, farthest) - radius;
  m_columns = m_rows = int(2.0f * radius / m_side) + 1;
  m_nearest.assign(std::size_t(m_columns) * std::size_t(m_rows), nothing);
  const auto positions = surface.mesh->positions();
  CellBlock cells;
  for (std::size_t first = 0; first < positions.size(); first += placesOfBlock) {
    const auto block = positions.subspan(first, std::min(placesOfBlock, positions.size() - first));
    findCells(block, {m_scale.frame(), m_low, 1.0f / m_side, m_columns, m_rows},
              eyeOf(camera).atInfinity, cells);
    for (std::size_t i = 0; i < block.size(); ++i)
      if (cells.cell[i] >= 0) {
        float& nearest = m_nearest[std::size_t(cells.cell[i])];
        nearest = std::min(nearest, cells.distance[i]);
      }
  }
}

std::ptrdiff_t CoarseDepth::cell(const glm::vec2& at) const {
  const glm::vec2 c = (at - m_low) / m_side;
  if (!(c.x >= 0.0f && c.y >= 0.0f && c.x < float(m_columns) && c.y < float(m_rows)))
    return -1;
  return std::ptrdiff_t(c.y) * m_columns + std::ptrdiff_t(c.x);
}

float CoarseDepth::nearest(const glm::vec2& at) const {
  const std::ptrdiff_t c = cell(at);
  return c < 0 ? nothing : m_nearest[std::size_t(c)];
}

bool CoarseDepth::sees(const glm::vec3& p) const {
  const ViewScale::Point seen = m_scale.project(p);
  return seen.perMm > 0.0f && seen.distanceMm <= nearest(seen.at) + m_slack;
}

bool CoarseDepth::surrounds(const glm::vec3& p, const glm::vec3& normal) const {
  const ViewScale::Point seen = m_scale.project(p);
  const glm::vec2 outwards = m_scale.across(normal);
  const float length = glm::length(outwards);
  return seen.perMm > 0.0f && length > 0.0f &&
         nearest(seen.at + 2.0f * m_side / length * outwards) < nothing;
}

}  // namespace sline::render
