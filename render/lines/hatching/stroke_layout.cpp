// SPDX-License-Identifier: Apache-2.0
#include "render/lines/hatching/stroke_layout.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/lines/hatching/stroke_placer.h"

namespace sline::render {

namespace {
// Cells of a level's lattice are this share of the distance between its strokes: several seeds
// compete for every place, and the first takes it.
constexpr float cellShare = 0.7f;
// A cube's side as a multiple of the distance between strokes, and how much longer it is than
// strokes at least, so that strokes of cubes that are not neighbours never meet.
constexpr float leastSide = 24.0f;
constexpr float sideMargin = 4.0f;
// Below this many points, of 38 bytes each, nothing is forgotten; above it, what exceeds so many
// times the points of the last view.
constexpr std::size_t fewPoints = 50'000;
constexpr std::size_t viewsKept = 4;
// Strokes lie at least this share of the farthest coordinate apart: some sixteen roundings.
constexpr float leastApart = 0x1p-19f;
// The most cells all over a surface from which to go on to finer ones. Where small forms decide on
// the distance between strokes, as beside a stray vertex far away, even the first level has more.
constexpr double mostCellsAtOnce = 4096.0;

model::Box grown(const model::Box& box, float by) {
  return {box.low - by, box.high + by};
}

int order(const LaidCell& cell) {
  return (cell.x & 1) | (cell.y & 1) << 1 | (cell.z & 1) << 2;
}
}  // namespace

bool touches(const model::Sphere& sphere, const model::Box& box) {
  const glm::vec3 away = sphere.centre - glm::clamp(sphere.centre, box.low, box.high);
  return glm::dot(away, away) <= sphere.radius * sphere.radius;
}

StrokeLayout::StrokeLayout(model::SurfacePtr surface, float length)
    : m_surface(std::move(surface)),
      m_neighbours(*m_surface->mesh),
      m_directions(*m_surface),
      m_length(length) {
  m_slots.resize(m_surface->clusters.triangles.size());
  for (std::size_t slot = 0; slot < m_slots.size(); ++slot)
    m_slots[m_surface->clusters.triangles[slot]] = std::uint32_t(slot);
  const float coarsest = 4.0f * m_surface->boundingSphere.radius;
  m_firstLevel = coarsestHatchLevel;
  while (m_firstLevel < finestHatchLevel && spacing(m_firstLevel) > coarsest)
    ++m_firstLevel;
  m_lastLevel = lastLevelApart();
}

int StrokeLayout::lastLevelApart() const {
  const model::Box& box = m_surface->mesh->bounds();
  float farthest = 0.0f;
  for (int axis = 0; axis < 3 && !box.empty(); ++axis)
    farthest = std::max({farthest, std::abs(box.low[axis]), std::abs(box.high[axis])});
  int level = finestHatchLevel;
  while (level >= m_firstLevel && !(spacing(level) > leastApart * farthest))
    --level;
  return level;
}

int StrokeLayout::levelOfFewCells() const {
  int level = m_firstLevel;
  while (rangeNear(level, m_surface->boundingSphere).count() > mostCellsAtOnce)
    --level;
  return level;
}

float StrokeLayout::spacing(int level) const {
  return std::ldexp(m_surface->filigreeSize / cellShare, -level);
}

float StrokeLayout::reach(int level) const {
  return 0.5f * m_length * spacing(level);
}

float StrokeLayout::side(int level) const {
  return std::max(leastSide, m_length + sideMargin) * spacing(level);
}

model::Box StrokeLayout::home(const LaidCell& cell) const {
  const glm::vec3 at(float(cell.x), float(cell.y), float(cell.z));
  const glm::vec3 origin = m_surface->boundingSphere.centre;
  return {origin + (at - 0.5f) * side(cell.level), origin + (at + 0.5f) * side(cell.level)};
}

model::Box StrokeLayout::reached(const LaidCell& cell) const {
  return grown(home(cell), reach(cell.level));
}

CellRange StrokeLayout::rangeWithin(int level, const model::Box& box) const {
  const glm::vec3 origin = m_surface->boundingSphere.centre;
  return {level, glm::floor((box.low - origin) / side(level) + 0.5f),
          glm::floor((box.high - origin) / side(level) + 0.5f)};
}

std::vector<LaidCell> StrokeLayout::cellsWithin(int level, const model::Box& box) const {
  std::vector<LaidCell> cells;
  rangeWithin(level, box).forEach([&cells](const LaidCell& cell) { cells.push_back(cell); });
  return cells;
}

CellRange StrokeLayout::rangeNear(int level, const model::Sphere& sphere) const {
  return rangeWithin(level, grown({sphere.centre, sphere.centre}, sphere.radius + reach(level)));
}

std::vector<LaidCell> StrokeLayout::cellsNear(int level, const model::Sphere& sphere) const {
  std::vector<LaidCell> cells;
  rangeNear(level, sphere).forEach([&cells](const LaidCell& cell) { cells.push_back(cell); });
  return cells;
}

SurfacePoint StrokeLayout::at(const LaidPoint& point) const {
  return {m_surface->clusters.triangles[point.slot], barycentric(point)};
}

glm::vec3 StrokeLayout::position(const LaidPoint& point) const {
  return valueAt(*m_surface->mesh, m_surface->mesh->positions(), at(point));
}

void StrokeLayout::beginView() {
  const std::lock_guard lock(m_mutex);
  const std::size_t most = std::max(fewPoints, viewsKept * m_shown);
  m_shown = 0;
  const std::uint32_t last = m_view++;
  if (m_points <= most)
    return;
  std::vector<KeptCell*> unused;
  for (KeptCell* cell : m_byNumber)
    if (cell->lastView != last && cell->tile)
      unused.push_back(cell);
  std::stable_sort(unused.begin(), unused.end(),
                   [](const KeptCell* a, const KeptCell* b) { return a->lastView < b->lastView; });
  for (KeptCell* cell : unused) {
    if (m_points <= most)
      return;
    m_points -= cell->tile->points.size();
    cell->tile = nullptr;
  }
}

std::shared_ptr<const LaidTile> StrokeLayout::tile(const LaidCell& cell) {
  const std::lock_guard lock(m_mutex);
  return found(kept(cell));
}

std::shared_ptr<const LaidTile> StrokeLayout::tile(const KeptCell& cell) {
  const std::lock_guard lock(m_mutex);
  return found(*m_byNumber[cell.number]);
}

const std::vector<const KeptCell*>& StrokeLayout::coarsest() {
  const std::lock_guard lock(m_mutex);
  if (!m_knowsCoarsest && m_lastLevel >= m_firstLevel)
    m_coarsest = reaching(rangeNear(levelOfFewCells(), m_surface->boundingSphere));
  m_knowsCoarsest = true;
  return m_coarsest;
}

const std::vector<const KeptCell*>& StrokeLayout::finer(const KeptCell& cell) {
  const std::lock_guard lock(m_mutex);
  if (!cell.knowsFiner) {
    std::vector<const KeptCell*> cells =
        reaching(rangeWithin(cell.cell.level + 1, home(cell.cell)));
    KeptCell& known = *m_byNumber[cell.number];
    known.finer = std::move(cells);
    known.knowsFiner = true;
  }
  return cell.finer;
}

std::size_t StrokeLayout::keptCount() {
  const std::lock_guard lock(m_mutex);
  return m_byNumber.size();
}

/// Returns the cells whose strokes may reach the surface.
std::vector<const KeptCell*> StrokeLayout::reaching(const CellRange& range) {
  std::vector<const KeptCell*> cells;
  range.forEach([&](const LaidCell& cell) {
    if (const auto known = m_cells.find(cell); known != m_cells.end()) {
      if (!known->second.clusters.empty())
        cells.push_back(&known->second);
    } else if (std::vector<std::uint32_t> clusters = clustersWithin(reached(cell));
               !clusters.empty()) {
      cells.push_back(&keep(cell, std::move(clusters)));
    }
  });
  return cells;
}

KeptCell& StrokeLayout::kept(const LaidCell& cell) {
  const auto known = m_cells.find(cell);
  return known != m_cells.end() ? known->second : keep(cell, clustersWithin(reached(cell)));
}

KeptCell& StrokeLayout::keep(const LaidCell& cell, std::vector<std::uint32_t> clusters) {
  KeptCell& fresh = m_cells[cell];
  fresh.cell = cell;
  fresh.number = m_byNumber.size();
  fresh.clusters = std::move(clusters);
  m_byNumber.push_back(&fresh);
  return fresh;
}

std::vector<std::uint32_t> StrokeLayout::clustersWithin(const model::Box& box) const {
  const std::vector<model::Cluster>& items = m_surface->clusters.items;
  const std::vector<model::Cluster>& groups = m_surface->clusters.groups;
  constexpr std::size_t most = model::Clusters::itemsOfGroup;
  std::vector<std::uint32_t> clusters;
  for (std::size_t group = 0; group < groups.size(); ++group)
    if (touches(groups[group].bounds, box))
      for (std::size_t c = group * most; c < std::min(items.size(), (group + 1) * most); ++c)
        if (touches(items[c].bounds, box))
          clusters.push_back(std::uint32_t(c));
  clusters.shrink_to_fit();
  return clusters;
}

std::shared_ptr<const LaidTile> StrokeLayout::found(KeptCell& known) {
  if (known.lastView != m_view && known.tile)
    m_shown += known.tile->points.size();
  known.lastView = m_view;
  if (!known.tile) {
    known.tile = std::make_shared<const LaidTile>(lay(known));
    m_points += known.tile->points.size();
    m_shown += known.tile->points.size();
  }
  return known.tile;
}

LaidTile StrokeLayout::lay(const KeptCell& known) {
  const LaidCell& cell = known.cell;
  if (cell.level < m_firstLevel)
    return {};
  const model::Box box = home(cell);
  std::vector<std::uint32_t> clusters;
  for (const std::uint32_t c : known.clusters)
    if (touches(m_surface->clusters.items[c].bounds, box))
      clusters.push_back(c);
  const glm::vec3 origin = m_surface->boundingSphere.centre;
  const std::vector<PlacedSeed> seeds =
      hatchSeeds(*m_surface, cell.level, {box.low - origin, box.high - origin}, clusters);
  if (seeds.empty())
    return {};
  const model::Box around = grown(reached(cell), spacing(cell.level));
  StrokeSpacing taken(spacing(cell.level), around);
  markAround(cell, around, taken);
  Placer placer(*this, cell.level, taken);
  for (const PlacedSeed& seed : seeds)
    placer.place(seed);
  return placer.take();
}

/// Takes over all strokes for which this cell's strokes must make way.
void StrokeLayout::markAround(const LaidCell& cell, const model::Box& box, StrokeSpacing& taken) {
  std::vector<LaidCell> others;
  for (int level = m_firstLevel; level < cell.level; ++level) {
    const std::vector<LaidCell> coarser = cellsWithin(level, grown(box, reach(level)));
    others.insert(others.end(), coarser.begin(), coarser.end());
  }
  for (std::int32_t z = -1; z <= 1; ++z)
    for (std::int32_t y = -1; y <= 1; ++y)
      for (std::int32_t x = -1; x <= 1; ++x) {
        const LaidCell neighbour{cell.level, cell.x + x, cell.y + y, cell.z + z};
        if (order(neighbour) < order(cell))
          others.push_back(neighbour);
      }
  for (const LaidCell& other : others) {
    const std::shared_ptr<const LaidTile> laid = found(kept(other));
    for (const LaidStroke& stroke : laid->strokes)
      if (touches(stroke.bounds, box))
        mark(*laid, stroke, spacing(cell.level), taken);
  }
}

StrokeSpacing::Mark StrokeLayout::markAt(const SurfacePoint& place) const {
  const glm::vec3 normal = valueAt(*m_surface->mesh, m_surface->normals, place);
  return {valueAt(*m_surface->mesh, m_surface->mesh->positions(), place),
          normal / std::max(glm::length(normal), 1e-20f)};
}

void StrokeLayout::mark(const LaidTile& tile, const LaidStroke& stroke, float distance,
                        StrokeSpacing& taken) {
  const auto markOf = [&](std::size_t point) -> StrokeSpacing::Mark {
    return {tile.position(stroke, point), tile.normal(stroke, point)};
  };
  StrokeSpacing::Mark last = markOf(0);
  taken.add(last);
  for (std::size_t i = 1; i < stroke.count; ++i) {
    const StrokeSpacing::Mark next = markOf(i);
    const float apart = glm::distance(next.position, last.position);
    if (apart < markStep * distance && i + 1 < stroke.count)
      continue;
    taken.addAlong(last.position, next, std::max(1, int(std::ceil(apart / (markStep * distance)))));
    last = next;
  }
}

}  // namespace sline::render
