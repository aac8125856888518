// SPDX-License-Identifier: Apache-2.0
#include "render/lines/hatch_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace sline::render {

namespace {
// Of F: what is nearer to the eye gets strokes no finer.
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

/// Goes from the coarsest cells to finer ones, but only where those would show.
class Descent {
 public:
  Descent(const StrokeLayout& layout, const ViewScale& scale, const Frustum& frustum, float spacing)
      : m_layout(layout), m_scale(scale), m_frustum(frustum), m_spacing(spacing) {}

  std::vector<LaidCell> cells(std::span<const std::uint32_t> clusters) {
    for (const std::uint32_t c : clusters) {
      const model::Sphere& bounds = m_layout.surface().clusters.items[c].bounds;
      if (m_frustum.misses(bounds))
        continue;
      for (const LaidCell& cell : m_layout.cellsNear(m_layout.firstLevel(), bounds))
        m_next[cell].push_back(c);
    }
    while (!m_next.empty()) {
      const std::map<LaidCell, std::vector<std::uint32_t>> level = std::move(m_next);
      m_next.clear();
      for (const auto& [cell, around] : level)
        look(cell, around);
    }
    return std::move(m_needed);
  }

 private:
  void look(const LaidCell& cell, std::vector<std::uint32_t> around) {
    const model::Box reached = m_layout.reached(cell);
    if (m_frustum.misses({reached.centre(), 0.5f * glm::distance(reached.low, reached.high)}))
      return;
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
    const float boxDepth = depthOf(m_scale, reached);
    bool needed = false;
    std::vector<std::uint32_t> finer;
    for (const std::uint32_t c : around) {
      const model::Sphere& bounds = m_layout.surface().clusters.items[c].bounds;
      if (!touches(bounds, reached))
        continue;
      const float depth =
          std::max(boxDepth, m_scale.project(bounds.centre).distanceMm - bounds.radius);
      const float level = levelAt(depth);
      needed = needed || level + 1.0f > float(cell.level);
      if (level > float(cell.level))
        finer.push_back(c);
    }
    if (needed)
      m_needed.push_back(cell);
    if (cell.level < finestHatchLevel && !finer.empty())
      for (const LaidCell& child : m_layout.cellsWithin(cell.level + 1, m_layout.home(cell)))
        m_next[child].insert(m_next[child].end(), finer.begin(), finer.end());
  }

  float levelAt(float depth) const {
    const float closest = nearest * m_layout.surface().featureSize;
    return hatchLevel(m_layout, m_scale.perMmAt(std::max(depth, closest)), m_spacing);
  }

  const StrokeLayout& m_layout;
  const ViewScale& m_scale;
  const Frustum& m_frustum;
  float m_spacing;
  std::map<LaidCell, std::vector<std::uint32_t>> m_next;
  std::vector<LaidCell> m_needed;
};
}  // namespace

float hatchLevel(const StrokeLayout& layout, float perMm, float spacing) {
  return std::log2(std::max(layout.spacing(0) * perMm / spacing, 1e-20f));
}

std::vector<LaidCell> neededCells(const StrokeLayout& layout,
                                  std::span<const std::uint32_t> clusters, const ViewScale& scale,
                                  const Frustum& frustum, float spacing) {
  return Descent(layout, scale, frustum, spacing).cells(clusters);
}

}  // namespace sline::render
