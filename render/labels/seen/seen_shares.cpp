// SPDX-License-Identifier: Apache-2.0
// Sums up over a picture what its cells show.
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "render/labels/seen/seen_map.h"

namespace sline::render {

namespace {

/// The least of a cell that one can tell from what is beside it.
constexpr float leastShown = 0.08f;
/// What comes through of a fragment at least where one may say that it is seen.
constexpr float comesThrough = 0.5f;
/// The most that comes through of what is hidden.
constexpr float hiddenReach = 0.25f;

}  // namespace

std::vector<SeenShare> SeenMap::shares() const {
  std::vector<SeenShare> sums(m_layers.size());
  for (int y = 0; y < m_grid.rows; ++y)
    for (int x = 0; x < m_grid.columns; ++x)
      for (const Fragment& one : fragments(x, y)) {
        const SeenLayer& layer = m_layers[one.layer];
        const float filled = one.reach * layer.fillOf(layer.at(x, y)).cover;
        // Paper has no colour of its own. The outline of what is filled is no more than its edge.
        const float shown = std::max(filled, one.colour);
        const float lines = layer.covers(x, y) && shown < leastShown ? one.ink : 0.0f;
        if (std::max(shown, lines) < leastShown)
          continue;
        sums[one.layer].cells += std::max(shown, lines);
        sums[one.layer].middle += std::max(shown, lines) * m_grid.middle(x, y);
      }
  std::vector<SeenShare> seen;
  for (std::size_t i = 0; i < sums.size(); ++i)
    if (sums[i].cells > 0.0f)
      seen.push_back({m_layers[i].node().id, sums[i].cells, sums[i].middle / sums[i].cells});
  std::stable_sort(seen.begin(), seen.end(),
                   [](const SeenShare& a, const SeenShare& b) { return a.cells > b.cells; });
  return seen;
}

std::vector<SeenCover> SeenMap::covers() const {
  std::vector<float> own(m_layers.size(), 0.0f);  // cells that would show it if it were alone
  std::map<std::pair<std::uint32_t, std::uint32_t>, float> hidden;
  for (int y = 0; y < m_grid.rows; ++y)
    for (int x = 0; x < m_grid.columns; ++x) {
      const std::span<const Fragment> here = fragments(x, y);
      for (std::size_t i = 0; i < here.size(); ++i) {
        own[here[i].layer] += 1.0f;
        if (here[i].reach > hiddenReach)
          continue;
        for (std::size_t j = 0; j < i; ++j) {
          const float after = here[j + 1].reach;
          const bool hides = here[j].reach >= comesThrough && after <= hiddenReach;
          const SeenLayer& before = m_layers[here[j].layer];
          const SeenCell& nearer = cellOf(here[j], x, y);
          const SeenCell& farther = cellOf(here[i], x, y);
          const bool sure = !before.touches(nearer, farther) && !before.inOneFace(nearer, farther);
          if (hides && sure && here[j].layer != here[i].layer)
            hidden[{here[j].layer, here[i].layer}] += 1.0f;
        }
      }
    }
  std::vector<SeenCover> all;
  all.reserve(hidden.size());
  for (const auto& [pair, cells] : hidden)
    all.push_back({m_layers[pair.first].node().id, m_layers[pair.second].node().id,
                   cells / own[pair.second]});
  std::stable_sort(all.begin(), all.end(),
                   [](const SeenCover& a, const SeenCover& b) { return a.share > b.share; });
  return all;
}

SeenArea SeenMap::areaOf(std::span<const model::NodeId> structures) const {
  std::vector<bool> wanted(m_layers.size(), false);
  for (const model::NodeId id : structures)
    if (const auto found = m_index.find(id); found != m_index.end())
      wanted[found->second] = true;
  SeenArea area{.grid = m_grid, .cells = {}};
  area.cells.resize(std::size_t(m_grid.columns) * std::size_t(m_grid.rows), false);
  for (int y = 0; y < m_grid.rows; ++y)
    for (int x = 0; x < m_grid.columns; ++x) {
      const Fragment* owner = nullptr;
      float most = leastShown;
      for (const Fragment& one : fragments(x, y)) {
        if (!m_layers[one.layer].covers(x, y))
          continue;
        if (!owner || one.colour > most) {
          owner = &one;
          most = std::max(most, one.colour);
        }
      }
      area.cells[std::size_t(y) * std::size_t(m_grid.columns) + std::size_t(x)] =
          owner && wanted[owner->layer];
    }
  return area;
}

bool SeenArea::anyIn(const LabelBox& box) const {
  const auto cell = [this](float mm, float corner) {
    return int(std::floor((mm - corner) / grid.side));
  };
  for (int y = cell(box.low.y, grid.corner.y); y <= cell(box.high.y, grid.corner.y); ++y)
    for (int x = cell(box.low.x, grid.corner.x); x <= cell(box.high.x, grid.corner.x); ++x)
      if (at(x, y))
        return true;
  return false;
}

SeenArea SeenMap::drawnArea() const {
  SeenArea area{.grid = m_grid, .cells = {}};
  area.cells.resize(std::size_t(m_grid.columns) * std::size_t(m_grid.rows));
  for (std::size_t i = 0; i < area.cells.size(); ++i)
    area.cells[i] = m_first[i + 1] > m_first[i];
  return area;
}

}  // namespace sline::render
