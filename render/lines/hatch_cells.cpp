// SPDX-License-Identifier: Apache-2.0
#include "render/lines/hatch_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace sline::render {

namespace {
// A share of F: surfaces nearer to the eye get no finer strokes.
constexpr float nearest = 1e-3f;

float depthOf(const ViewScale& scale, const model::Box& box) {
  float depth = std::numeric_limits<float>::infinity();
  for (int corner = 0; corner < 8; ++corner)
    depth = std::min(depth, scale
                                .project({corner & 1 ? box.high.x : box.low.x,
                                          corner & 2 ? box.high.y : box.low.y,
                                          corner & 4 ? box.high.z : box.low.z})
                                .distanceMm);
  return depth;
}

constexpr float unseen = -std::numeric_limits<float>::infinity();

/// Goes from the coarsest cells to finer ones, but only where those would show.
class Descent {
 public:
  Descent(StrokeLayout& layout, const ViewScale& scale, const Frustum& frustum, float spacing)
      : m_layout(layout),
        m_scale(scale),
        m_frustum(frustum),
        m_spacing(spacing),
        m_finest(layout.surface().clusters.items.size(), unseen) {}

  std::vector<LaidCell> cells(std::span<const std::uint32_t> clusters) {
    for (const std::uint32_t c : clusters) {
      const model::Sphere& bounds = m_layout.surface().clusters.items[c].bounds;
      if (!m_frustum.misses(bounds))
        m_finest[c] = levelAt(m_scale.project(bounds.centre).distanceMm - bounds.radius);
    }
    std::vector<LaidCell> candidates =
        m_layout.cellsNear(m_layout.firstLevel(), m_layout.surface().boundingSphere);
    std::vector<LaidCell> next;
    while (!candidates.empty()) {
      next.clear();
      for (const LaidCell& candidate : candidates)
        refine(candidate, next);
      std::sort(next.begin(), next.end());
      next.erase(std::unique(next.begin(), next.end()), next.end());
      std::swap(candidates, next);
    }
    return std::move(m_needed);
  }

 private:
  /// Returns the finest level that shows on clusters which strokes of the cell may reach; or any
  /// that is finer than the cell's.
  float finestReached(const LaidCell& cell) {
    float finest = unseen;
    for (const std::uint32_t c : *m_layout.clustersReached(cell)) {
      finest = std::max(finest, m_finest[c]);
      if (finest > float(cell.level))
        break;
    }
    return finest;
  }

  void refine(const LaidCell& cell, std::vector<LaidCell>& next) {
    const int level = cell.level;
    const float finest = finestReached(cell);
    if (finest + 1.0f <= float(level))
      return;
    const model::Box reached = m_layout.reached(cell);
    if (m_frustum.misses({reached.centre(), 0.5f * glm::distance(reached.low, reached.high)}))
      return;
    const float shown = std::min(finest, levelAt(depthOf(m_scale, reached)));
    if (shown + 1.0f > float(level))
      m_needed.push_back(cell);
    if (level >= finestHatchLevel || shown <= float(level))
      return;
    m_layout.rangeWithin(level + 1, m_layout.home(cell)).forEach([&next](const LaidCell& finer) {
      next.push_back(finer);
    });
  }

  float levelAt(float depth) const {
    const float closest = nearest * m_layout.surface().featureSize;
    return hatchLevel(m_layout, m_scale.perMmAt(std::max(depth, closest)), m_spacing);
  }

  StrokeLayout& m_layout;
  const ViewScale& m_scale;
  const Frustum& m_frustum;
  float m_spacing;
  std::vector<float> m_finest;  ///< by cluster: the finest level that shows on it
  std::vector<LaidCell> m_needed;
};
}  // namespace

float hatchLevel(const StrokeLayout& layout, float perMm, float spacing) {
  return std::log2(std::max(layout.spacing(0) * perMm / spacing, 1e-20f));
}

std::vector<LaidCell> neededCells(StrokeLayout& layout, std::span<const std::uint32_t> clusters,
                                  const ViewScale& scale, const Frustum& frustum, float spacing) {
  return Descent(layout, scale, frustum, spacing).cells(clusters);
}

}  // namespace sline::render
