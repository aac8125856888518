// SPDX-License-Identifier: Apache-2.0
#include "render/lines/stroke_layout.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/lines/stroke_directions.h"

namespace sline::render {

namespace {
// Cells of a level's lattice are this share of the distance between its strokes: several seeds for
// every place, of which the first takes it.
constexpr float cellShare = 0.7f;
// A cube's side over the distance between strokes, and how much longer it is than strokes at least:
// so strokes of cubes that are not neighbours never meet.
constexpr float leastSide = 24.0f;
constexpr float sideMargin = 4.0f;
// Shares of the distance: a stroke starts where others leave this room, and ends where they come
// nearer than the second.
constexpr float roomToStart = 0.85f;
constexpr float roomToGoOn = 0.55f;
// Shorter strokes, in distances, are left out.
constexpr float shortest = 1.5f;
// Points along a stroke, in distances; not much denser than the mesh, which they follow.
constexpr float step = 0.25f;
constexpr float finestStep = step / 16.0f;
constexpr float markStep = 0.35f;
// A stroke that comes round to itself, after this many distances, ends as at another.
constexpr float roundTrip = 2.0f;
// A triangle spans this many cubes at most: on larger ones hatching gets no finer.
constexpr float mostCubes = 16.0f;

LaidPoint packed(const SurfacePoint& at) {
  return {.triangle = at.triangle,
          .second = std::uint16_t(std::lround(65535.0f * at.barycentric.y)),
          .third = std::uint16_t(std::lround(65535.0f * at.barycentric.z))};
}

model::Box grown(const model::Box& box, float by) {
  return {box.low - by, box.high + by};
}

bool touches(const model::Sphere& sphere, const model::Box& box) {
  const glm::vec3 away = sphere.centre - glm::clamp(sphere.centre, box.low, box.high);
  return glm::dot(away, away) <= sphere.radius * sphere.radius;
}

int order(const LaidCell& cell) {
  return (cell.x & 1) | (cell.y & 1) << 1 | (cell.z & 1) << 2;
}
}  // namespace

/// Lays one cube's strokes.
class StrokeLayout::Placer {
 public:
  Placer(const StrokeLayout& layout, int level, StrokeSpacing& taken)
      : m_layout(layout), m_distance(layout.spacing(level)), m_taken(taken) {
    const float edge = layout.surface().meanEdge;
    m_step = std::clamp(edge, finestStep * m_distance, step * m_distance);
  }

  void place(const PlacedSeed& seed) {
    if (m_taken.room(markAt(seed.at)) < roomToStart)
      return;
    m_points.clear();
    m_marks.clear();
    m_points.push_back(seed.at);
    if (m_layout.length() > 0.0f) {
      const float behind = follow(seed.at, false);
      std::reverse(m_points.begin(), m_points.end());
      m_seedPoint = std::uint32_t(m_points.size() - 1);
      if (behind + follow(seed.at, true) < shortest * m_distance)
        return;
    } else {
      m_seedPoint = 0;
    }
    keep(seed);
  }

  LaidTile take() { return std::move(m_tile); }

 private:
  StrokeSpacing::Mark markAt(const SurfacePoint& at) const {
    const model::Surface& surface = m_layout.surface();
    const glm::vec3 normal = valueAt(*surface.mesh, surface.normals, at);
    return {valueAt(*surface.mesh, surface.mesh->positions(), at),
            normal / std::max(glm::length(normal), 1e-20f)};
  }

  /// Appends points one way from the seed on; returns how far, mm.
  float follow(const SurfacePoint& seed, bool along) {
    SurfaceWalk walk(m_layout.surface(), m_layout.m_neighbours, m_layout.m_directions, seed);
    if (!walk.start(along))
      return 0.0f;
    const float half = 0.5f * m_layout.length() * m_distance;
    float gone = 0.0f;
    float marked = 0.0f;
    bool more = true;
    while (more && gone + m_step <= half) {
      more = walk.advance(m_step);
      gone += m_step;
      const StrokeSpacing::Mark mark = markAt(walk.at());
      const float place = along ? gone : -gone;
      if (m_taken.room(mark) < roomToGoOn || meetsItself(mark, place))
        break;
      m_points.push_back(walk.at());
      if (gone - marked >= markStep * m_distance) {
        m_marks.push_back({mark, place});
        marked = gone;
      }
    }
    return gone;
  }

  bool meetsItself(const StrokeSpacing::Mark& mark, float place) const {
    const float near = roomToGoOn * m_distance;
    for (const Own& own : m_marks) {
      if (std::abs(place - own.place) < roundTrip * m_distance)
        continue;
      const glm::vec3 apart = mark.position - own.mark.position;
      if (glm::dot(apart, apart) < near * near && glm::dot(mark.normal, own.mark.normal) > 0.0f)
        return true;
    }
    return false;
  }

  void keep(const PlacedSeed& seed) {
    LaidStroke stroke{.seed = seed.name,
                      .bounds = {},
                      .first = std::uint32_t(m_tile.points.size()),
                      .count = std::uint32_t(m_points.size()),
                      .seedPoint = 0};
    stroke.seedPoint = stroke.first + m_seedPoint;
    model::Box box;
    for (const SurfacePoint& at : m_points) {
      m_tile.points.push_back(packed(at));
      box.add(m_layout.position(m_tile.points.back()));
    }
    stroke.bounds = {box.centre(), 0.5f * glm::length(box.size())};
    m_tile.strokes.push_back(stroke);
    m_layout.mark(m_tile, stroke, m_distance, m_taken);
  }

  struct Own {
    StrokeSpacing::Mark mark;
    float place;  ///< mm from the seed along the stroke, negative one way
  };
  const StrokeLayout& m_layout;
  float m_distance;
  float m_step;
  StrokeSpacing& m_taken;
  std::vector<SurfacePoint> m_points;
  std::vector<Own> m_marks;
  std::uint32_t m_seedPoint = 0;
  LaidTile m_tile;
};

StrokeLayout::StrokeLayout(model::SurfacePtr surface, float length)
    : m_surface(std::move(surface)),
      m_neighbours(*m_surface->mesh),
      m_directions(strokeDirections(*m_surface)),
      m_length(length) {
  const float coarsest = 4.0f * m_surface->boundingSphere.radius;
  m_firstLevel = coarsestHatchLevel;
  while (m_firstLevel < finestHatchLevel && spacing(m_firstLevel) > coarsest)
    ++m_firstLevel;
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

model::Box StrokeLayout::box(const LaidCell& cell) const {
  const glm::vec3 at(float(cell.x), float(cell.y), float(cell.z));
  return {(at - 0.5f) * side(cell.level), (at + 0.5f) * side(cell.level)};
}

model::Sphere StrokeLayout::bounds(const LaidCell& cell) const {
  const model::Box strokes = grown(box(cell), reach(cell.level));
  return {strokes.centre() + m_surface->boundingSphere.centre, 0.5f * glm::length(strokes.size())};
}

void StrokeLayout::addCells(int level, const model::Box& box, std::vector<LaidCell>& cells) const {
  const glm::vec3 low = glm::floor(box.low / side(level) + 0.5f);
  const glm::vec3 high = glm::floor(box.high / side(level) + 0.5f);
  for (float z = low.z; z <= high.z; z += 1.0f)
    for (float y = low.y; y <= high.y; y += 1.0f)
      for (float x = low.x; x <= high.x; x += 1.0f)
        cells.push_back({level, std::int32_t(x), std::int32_t(y), std::int32_t(z)});
}

void StrokeLayout::addCells(int level, const model::Cluster& cluster,
                            std::vector<LaidCell>& cells) const {
  const glm::vec3 origin = m_surface->boundingSphere.centre;
  if (cluster.bounds.radius < side(level)) {
    const glm::vec3 middle = cluster.bounds.centre - origin;
    addCells(level, grown({middle, middle}, cluster.bounds.radius + reach(level)), cells);
    return;
  }
  const auto positions = m_surface->mesh->positions();
  for (std::uint32_t i = 0; i < cluster.triangleCount; ++i) {
    model::Box box;
    for (const std::uint32_t vertex :
         m_surface->mesh->triangles()[m_surface->clusters.triangles[cluster.firstTriangle + i]])
      box.add(positions[vertex] - origin);
    const glm::vec3 size = box.size();
    if (std::max({size.x, size.y, size.z}) <= mostCubes * side(level))
      addCells(level, grown(box, reach(level)), cells);
  }
}

SurfacePoint StrokeLayout::at(const LaidPoint& point) const {
  const float second = float(point.second) / 65535.0f;
  const float third = float(point.third) / 65535.0f;
  return {point.triangle, {1.0f - second - third, second, third}};
}

glm::vec3 StrokeLayout::position(const LaidPoint& point) const {
  return valueAt(*m_surface->mesh, m_surface->mesh->positions(), at(point));
}

const LaidTile& StrokeLayout::tile(const LaidCell& cell) {
  const std::lock_guard lock(m_mutex);
  return found(cell);
}

const LaidTile& StrokeLayout::found(const LaidCell& cell) {
  if (const auto known = m_tiles.find(cell); known != m_tiles.end())
    return known->second;
  LaidTile laid = lay(cell);
  return m_tiles.emplace(cell, std::move(laid)).first->second;
}

LaidTile StrokeLayout::lay(const LaidCell& cell) {
  const model::Box home = box(cell);
  std::vector<std::uint32_t> clusters;
  for (std::size_t c = 0; c < m_surface->clusters.items.size(); ++c) {
    model::Sphere bounds = m_surface->clusters.items[c].bounds;
    bounds.centre -= m_surface->boundingSphere.centre;
    if (touches(bounds, home))
      clusters.push_back(std::uint32_t(c));
  }
  const std::vector<PlacedSeed> seeds = hatchSeeds(*m_surface, cell.level, home, clusters);
  if (seeds.empty())
    return {};
  const model::Box around = grown(home, reach(cell.level) + spacing(cell.level));
  const glm::vec3 origin = m_surface->boundingSphere.centre;
  StrokeSpacing taken(spacing(cell.level), {around.low + origin, around.high + origin});
  markAround(cell, around, taken);
  Placer placer(*this, cell.level, taken);
  for (const PlacedSeed& seed : seeds)
    placer.place(seed);
  return placer.take();
}

/// Takes over all strokes that this cell's have to make way for.
void StrokeLayout::markAround(const LaidCell& cell, const model::Box& box, StrokeSpacing& taken) {
  std::vector<LaidCell> others;
  for (int level = m_firstLevel; level < cell.level; ++level)
    addCells(level, grown(box, reach(level)), others);
  for (std::int32_t z = -1; z <= 1; ++z)
    for (std::int32_t y = -1; y <= 1; ++y)
      for (std::int32_t x = -1; x <= 1; ++x) {
        const LaidCell neighbour{cell.level, cell.x + x, cell.y + y, cell.z + z};
        if (order(neighbour) < order(cell))
          others.push_back(neighbour);
      }
  const glm::vec3 origin = m_surface->boundingSphere.centre;
  for (const LaidCell& other : others) {
    const LaidTile& laid = found(other);
    for (const LaidStroke& stroke : laid.strokes)
      if (touches({stroke.bounds.centre - origin, stroke.bounds.radius}, box))
        mark(laid, stroke, spacing(cell.level), taken);
  }
}

void StrokeLayout::mark(const LaidTile& tile, const LaidStroke& stroke, float distance,
                        StrokeSpacing& taken) const {
  const auto markOf = [&](std::uint32_t i) {
    const SurfacePoint place = at(tile.points[i]);
    const glm::vec3 normal = valueAt(*m_surface->mesh, m_surface->normals, place);
    return StrokeSpacing::Mark{valueAt(*m_surface->mesh, m_surface->mesh->positions(), place),
                               normal / std::max(glm::length(normal), 1e-20f)};
  };
  StrokeSpacing::Mark last = markOf(stroke.first);
  taken.add(last);
  for (std::uint32_t i = stroke.first + 1; i < stroke.first + stroke.count; ++i) {
    const StrokeSpacing::Mark next = markOf(i);
    const float apart = glm::distance(next.position, last.position);
    if (apart < markStep * distance && i + 1 < stroke.first + stroke.count)
      continue;
    const int pieces = std::max(1, int(std::ceil(apart / (markStep * distance))));
    for (int k = 1; k <= pieces; ++k)
      taken.add({glm::mix(last.position, next.position, float(k) / float(pieces)), next.normal});
    last = next;
  }
}

}  // namespace sline::render
