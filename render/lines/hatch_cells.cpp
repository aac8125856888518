// SPDX-License-Identifier: Apache-2.0
#include "render/lines/hatch_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

/// Goes from the coarsest cells to finer ones, but only where those would show.
class Descent {
 public:
  Descent(const StrokeLayout& layout, const ViewScale& scale, const Frustum& frustum, float spacing)
      : m_layout(layout), m_scale(scale), m_frustum(frustum), m_spacing(spacing) {}

  std::vector<LaidCell> cells(std::span<const std::uint32_t> clusters) {
    for (const std::uint32_t c : clusters) {
      const model::Sphere& bounds = m_layout.surface().clusters.items[c].bounds;
      if (!m_frustum.misses(bounds))
        m_seen.push_back(
            {bounds, levelAt(m_scale.project(bounds.centre).distanceMm - bounds.radius)});
    }
    std::vector<LaidCell> next =
        m_layout.cellsNear(m_layout.firstLevel(), m_layout.surface().boundingSphere);
    for (int level = m_layout.firstLevel(); !next.empty(); ++level) {
      std::sort(next.begin(), next.end());
      next.erase(std::unique(next.begin(), next.end()), next.end());
      m_candidates.clear();
      for (const LaidCell& cell : next)
        m_candidates.push_back({cell, m_layout.reached(cell)});
      next.clear();
      for (const Seen& seen : m_seen)
        if (seen.level + 1.0f > float(level))
          raise(level, seen);
      for (const Candidate& candidate : m_candidates)
        refine(candidate, next);
    }
    return std::move(m_needed);
  }

 private:
  struct Seen {
    model::Sphere bounds;  ///< of the cluster
    float level;           ///< the finest level that shows on it
  };
  struct Candidate {
    LaidCell cell;
    model::Box reached;
    float level = -std::numeric_limits<float>::infinity();  ///< finest of clusters reached
  };

  /// Tells the candidates that reach the cluster how fine strokes on it are.
  void raise(int level, const Seen& seen) {
    const auto tell = [&seen](Candidate& candidate) {
      if (seen.level > candidate.level && touches(seen.bounds, candidate.reached))
        candidate.level = seen.level;
    };
    const CellRange near = m_layout.rangeNear(level, seen.bounds);
    // A cluster around the eye has strokes so fine that it has more cells than there are
    // candidates.
    if (near.count() >= double(m_candidates.size())) {
      std::for_each(m_candidates.begin(), m_candidates.end(), tell);
      return;
    }
    near.forEach([&](const LaidCell& cell) {
      const auto at = std::lower_bound(
          m_candidates.begin(), m_candidates.end(), cell,
          [](const Candidate& candidate, const LaidCell& c) { return candidate.cell < c; });
      if (at != m_candidates.end() && at->cell == cell)
        tell(*at);
    });
  }

  void refine(const Candidate& candidate, std::vector<LaidCell>& next) {
    const model::Box& reached = candidate.reached;
    const int level = candidate.cell.level;
    if (candidate.level + 1.0f <= float(level) ||
        m_frustum.misses({reached.centre(), 0.5f * glm::distance(reached.low, reached.high)}))
      return;
    const float shown = std::min(candidate.level, levelAt(depthOf(m_scale, reached)));
    if (shown + 1.0f > float(level))
      m_needed.push_back(candidate.cell);
    if (level >= finestHatchLevel || shown <= float(level))
      return;
    m_layout.rangeWithin(level + 1, m_layout.home(candidate.cell))
        .forEach([&next](const LaidCell& cell) { next.push_back(cell); });
  }

  float levelAt(float depth) const {
    const float closest = nearest * m_layout.surface().featureSize;
    return hatchLevel(m_layout, m_scale.perMmAt(std::max(depth, closest)), m_spacing);
  }

  const StrokeLayout& m_layout;
  const ViewScale& m_scale;
  const Frustum& m_frustum;
  float m_spacing;
  std::vector<Seen> m_seen;
  std::vector<Candidate> m_candidates;  ///< of the level under examination, ascending
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
