// SPDX-License-Identifier: Apache-2.0
#include "render/software/occlusion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "model/base/parallel.h"
#include "render/sight/rules.h"
#include "render/strokes/coverage.h"
#include "render/strokes/structure_lines.h"

namespace sline::render {

namespace {

constexpr int side = TileMask::side;
// So many samples around a square have to be opaque, too: what is enlarged mixes those around it,
// and is trimmed along outlines (trims.cpp).
constexpr int opaqueAround = 3;
// Lines lie in front of their surface by a part of this many edges of its triangles.
constexpr float edgesInFront = 4.0f;
constexpr float filigreeInFront = 0.02f;

/// Returns the whole numbers not above, or not below, a quotient.
int below(int number, int by) {
  return int(std::floor(float(number) / float(by)));
}
int above(int number, int by) {
  return int(std::ceil(float(number) / float(by)));
}

/// Tells which samples of a layer stand for a square of the region.
class SquareSamples {
 public:
  SquareSamples(const LayerPixels& pixels, const PixelRect& region)
      : m_region(region),
        m_step(pixels.step()),
        // Where the first sample's lower left pixel lies in the region.
        m_first(pixels.samples.grid.corner +
                m_step * glm::ivec2(pixels.samples.area.x, pixels.samples.area.y) -
                glm::ivec2(region.x, region.y)) {}

  const glm::ivec2& first() const { return m_first; }
  /// Returns the first one and the one after the last, with so many around them. Nothing beyond the
  /// region's edge counts.
  glm::ivec2 columns(int column, int around) const {
    return samplesOf(column, m_first.x, m_region.width, around);
  }
  glm::ivec2 rows(int row, int around) const {
    return samplesOf(row, m_first.y, m_region.height, around);
  }

 private:
  glm::ivec2 samplesOf(int square, int origin, int end, int around) const {
    return {below(square * side - origin, m_step) - around,
            above(std::min((square + 1) * side, end) - origin, m_step) + around};
  }

  const PixelRect& m_region;
  int m_step;
  glm::ivec2 m_first;
};

float inFrontOf(const model::Surface& surface) {
  return edgesInFront * surface.meanEdge + filigreeInFront * surface.filigreeSize;
}

}  // namespace

Occlusion::Occlusion(const PictureView& view, const PixelRect& region)
    : m_view(view),
      m_region(region),
      m_columns((region.width + side - 1) / side),
      m_rows((region.height + side - 1) / side),
      m_farthest(std::size_t(m_columns) * std::size_t(m_rows),
                 std::numeric_limits<float>::infinity()) {}

void Occlusion::add(const LayerPixels& pixels) {
  const PixelRect& samples = pixels.samples.area;
  const int step = pixels.step();
  const std::vector<std::uint32_t>& colours = step > 1 ? pixels.surfaceColours : pixels.colours;
  if (colours.empty())
    return;
  const SquareSamples squares(pixels, m_region);
  const glm::ivec2& first = squares.first();
  // Returns the farthest depth of these samples; more than 1 where one is not opaque.
  const auto farthest = [&](const glm::ivec2& columns, const glm::ivec2& rows) {
    float most = 0.0f;
    for (int y = rows.x; y < rows.y; ++y)
      for (int x = columns.x; x < columns.y; ++x) {
        const std::size_t at = std::size_t(y) * std::size_t(samples.width) + std::size_t(x);
        if ((colours[at] >> 24) != 255u || !(pixels.surfaceDepths[at] < 1.0f))
          return 2.0f;
        most = std::max(most, pixels.surfaceDepths[at]);
      }
    return most;
  };
  const int firstRow = std::max(below(first.y, side), 0);
  const int endRow = std::min(above(first.y + step * samples.height, side), m_rows);
  const int firstColumn = std::max(below(first.x, side), 0);
  const int endColumn = std::min(above(first.x + step * samples.width, side), m_columns);
  parallelFor(std::size_t(std::max(endRow - firstRow, 0)), 4, [&](std::size_t i) {
    const int row = firstRow + int(i);
    const glm::ivec2 rows = squares.rows(row, opaqueAround);
    if (rows.x < 0 || rows.y > samples.height)
      return;
    for (int column = firstColumn; column < endColumn; ++column) {
      const glm::ivec2 columns = squares.columns(column, opaqueAround);
      if (columns.x < 0 || columns.y > samples.width)
        continue;
      const float depth = farthest(columns, rows);
      float& known = m_farthest[std::size_t(row) * std::size_t(m_columns) + std::size_t(column)];
      if (depth <= 1.0f)
        known = std::min(known, rule::eyeDistance(depth, m_view.depthTerms()));
    }
  });
}

bool Occlusion::hides(const DrawnStructure& shown) const {
  if (shown.cut)
    return false;
  const bool cull = cullsBack(shown, m_view);
  const int reach = strokeReach(shown, m_view);
  const std::vector<model::Cluster>& clusters = shown.surface().clusters.items;
  return std::all_of(clusters.begin(), clusters.end(), [&](const model::Cluster& cluster) {
    return (cull && model::facing(cluster, m_view.eye()) == model::Facing::back) ||
           hides(shown.surface(), cluster, reach);
  });
}

bool Occlusion::hides(const model::Surface& surface, const model::Cluster& cluster,
                      int around) const {
  const model::Sphere& bounds = cluster.bounds;
  const float middle = rule::eyeDistance(m_view.project(bounds.centre).depth, m_view.depthTerms());
  return covers(grown(m_view.bounds(bounds), around), middle - bounds.radius - inFrontOf(surface));
}

bool Occlusion::hides(const model::Surface& surface, const Stroke& stroke, int around) const {
  const float nearest = std::min(stroke.depthA, stroke.depthB);
  return covers(grown(strokeBounds(stroke), around),
                rule::eyeDistance(nearest, m_view.depthTerms()) -
                    std::max(inFrontOf(surface), 2.0f * stroke.tolerance));
}

bool Occlusion::unmarkHidden(const LayerPixels& pixels, TileMask& mask) const {
  const PixelRect& samples = pixels.samples.area;
  const SquareSamples squares(pixels, m_region);
  bool hidden = false;
  mask.unmarkIf([&](int column, int row) {
    // What is enlarged mixes one more sample on each side.
    const glm::ivec2 columns = glm::clamp(squares.columns(column, 1), 0, samples.width);
    const glm::ivec2 rows = glm::clamp(squares.rows(row, 1), 0, samples.height);
    float nearest = 1.0f;
    for (int y = rows.x; y < rows.y; ++y) {
      const float* depths =
          pixels.surfaceDepths.data() + std::size_t(y) * std::size_t(samples.width);
      for (int x = columns.x; x < columns.y; ++x)
        nearest = std::min(nearest, depths[x]);
    }
    // Nor does anything beyond the region's edge show.
    if (!(nearest < 1.0f))
      return true;
    if (column < 0 || row < 0 || column >= m_columns || row >= m_rows ||
        !(m_farthest[std::size_t(row) * std::size_t(m_columns) + std::size_t(column)] <
          rule::eyeDistance(nearest, m_view.depthTerms())))
      return false;
    hidden = true;
    return true;
  });
  return hidden;
}

bool Occlusion::covers(const PixelRect& pixels, float distance) const {
  const PixelRect seen = intersection(pixels, m_region);
  if (seen.empty())
    return true;
  const auto square = [](int pixel) { return pixel / side; };
  for (int row = square(seen.y - m_region.y); row <= square(seen.top() - 1 - m_region.y); ++row)
    for (int column = square(seen.x - m_region.x); column <= square(seen.right() - 1 - m_region.x);
         ++column)
      if (!(m_farthest[std::size_t(row) * std::size_t(m_columns) + std::size_t(column)] < distance))
        return false;
  return true;
}

}  // namespace sline::render
