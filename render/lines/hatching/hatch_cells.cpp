// SPDX-License-Identifier: Apache-2.0
#include "render/lines/hatching/hatch_cells.h"

#include <algorithm>
#include <glm/geometric.hpp>
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

/// Goes from the coarsest cells to finer ones, but only where those would show. A level shows where
/// its strokes are seen `spacing` λ apart: where a millimetre takes so many λ that its spacing
/// does.
class Descent {
 public:
  Descent(StrokeLayout& layout, const CellsView& view)
      : m_layout(layout),
        m_view(view),
        m_largest(view.scale.perMmAt(nearest * layout.surface().featureSize)),
        m_perMm(layout.surface().clusters.items.size(), 0.0f) {}

  std::vector<const KeptCell*> cells() {
    const model::Clusters& clusters = m_layout.surface().clusters;
    constexpr std::size_t most = model::Clusters::itemsOfGroup;
    for (std::size_t group = 0; group < clusters.groups.size(); ++group)
      if (shows(clusters.groups[group]))
        for (std::size_t c = group * most; c < std::min(clusters.items.size(), (group + 1) * most);
             ++c)
          if (const model::Cluster& cluster = clusters.items[c]; shows(cluster)) {
            const model::Sphere& bounds = cluster.bounds;
            m_perMm[c] = perMmAt(m_view.scale.project(bounds.centre).distanceMm - bounds.radius);
          }
    std::vector<const KeptCell*> candidates = m_layout.coarsest();
    for (std::size_t seen = 0;
         !candidates.empty() && (seen == 0 || seen + candidates.size() <= m_view.mostCells);) {
      seen += candidates.size();
      m_next.clear();
      for (const KeptCell* candidate : candidates)
        refine(*candidate);
      std::swap(candidates, m_next);
    }
    std::sort(m_needed.begin(), m_needed.end(),
              [](const KeptCell* a, const KeptCell* b) { return a->cell < b->cell; });
    return std::move(m_needed);
  }

 private:
  bool shows(const model::Cluster& cluster) const {
    return (m_view.twoSided || model::facing(cluster, m_view.eye) != model::Facing::back) &&
           !m_view.frustum.misses(cluster.bounds);
  }

  /// Returns the most λ that a millimetre takes on clusters which strokes of the cell may reach; or
  /// any number above `enough`.
  float mostReached(const KeptCell& cell, float enough) const {
    float most = 0.0f;
    for (const std::uint32_t c : cell.clusters) {
      most = std::max(most, m_perMm[c]);
      if (most > enough)
        break;
    }
    return most;
  }

  void refine(const KeptCell& cell) {
    const int level = cell.cell.level;
    const float whole = m_view.spacing / m_layout.spacing(level);
    const float most = mostReached(cell, whole);
    if (2.0f * most <= whole)
      return;
    const model::Box reached = m_layout.reached(cell.cell);
    if (m_view.frustum.misses({reached.centre(), 0.5f * glm::distance(reached.low, reached.high)}))
      return;
    const float shown = std::min(most, perMmAt(depthOf(m_view.scale, reached)));
    if (2.0f * shown > whole)
      m_needed.push_back(&cell);
    if (level >= m_layout.lastLevel() || shown <= whole)
      return;
    for (const KeptCell* finer : m_layout.finer(cell)) {
      if (m_seen.size() <= finer->number)
        m_seen.resize(m_layout.keptCount(), false);
      if (!m_seen[finer->number])
        m_next.push_back(finer);
      m_seen[finer->number] = true;
    }
  }

  /// Returns how many λ a millimetre takes at that distance from the eye's plane, or nearer.
  float perMmAt(float depth) const {
    const float there = m_view.scale.perMmAt(depth);
    return there > 0.0f ? std::min(there, m_largest) : m_largest;
  }

  StrokeLayout& m_layout;
  const CellsView& m_view;
  float m_largest;             ///< for surfaces that are near the eye
  std::vector<float> m_perMm;  ///< the most λ that a millimetre takes on each cluster; 0: unseen
  std::vector<bool> m_seen;    ///< by number of a cell
  std::vector<const KeptCell*> m_next;
  std::vector<const KeptCell*> m_needed;
};
}  // namespace

std::vector<const KeptCell*> neededCells(StrokeLayout& layout, const CellsView& view) {
  return Descent(layout, view).cells();
}

}  // namespace sline::render
