// SPDX-License-Identifier: Apache-2.0
#include "render/lines/stroke_layout.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace sline::render {

namespace {
// Cells of a level's lattice are this share of the distance between its strokes: several seeds
// compete for every place, and the first takes it.
constexpr float cellShare = 0.7f;
// A cube's side as a multiple of the distance between strokes, and how much longer it is than
// strokes at least, so that strokes of cubes that are not neighbours never meet.
constexpr float leastSide = 24.0f;
constexpr float sideMargin = 4.0f;
// Shares of the distance: a stroke starts where others leave this room, and ends where they come
// nearer than the second.
constexpr float roomToStart = 0.85f;
constexpr float roomToGoOn = 0.55f;
// Strokes shorter than this, in distances, are left out.
constexpr float shortest = 1.5f;
// The distance of points along a stroke, in distances between strokes; not much denser than the
// mesh, which they follow.
constexpr float step = 0.25f;
constexpr float finestStep = step / 16.0f;
constexpr float markStep = 0.35f;
// A stroke that comes round to itself, after this many distances, ends as it would at another
// stroke.
constexpr float roundTrip = 2.0f;
// A stroke may not turn within the surface by more than this many radians in about a distance:
// around the field's singular points strokes would curl.
constexpr float sharpestBend = 0.7f;
// Below this many points nothing is forgotten; above it, tiles that the last views did not ask for
// are forgotten.
constexpr std::size_t fewPoints = 10'000;
constexpr std::uint32_t viewsKept = 12;

LaidPoint packed(const SurfacePoint& at) {
  return {.triangle = at.triangle,
          .second = std::uint16_t(std::lround(65535.0f * at.barycentric.y)),
          .third = std::uint16_t(std::lround(65535.0f * at.barycentric.z))};
}

model::Box grown(const model::Box& box, float by) {
  return {box.low - by, box.high + by};
}

int order(const LaidCell& cell) {
  return (cell.x & 1) | (cell.y & 1) << 1 | (cell.z & 1) << 2;
}
}  // namespace

/// Tracks how much a stroke has turned lately: within the surface, not with it.
class Bend {
 public:
  explicit Bend(const glm::vec3& start) : m_last(start) {}

  /// Returns the radians at the next place; turns are forgotten over `distance` mm.
  float after(const StrokeSpacing::Mark& mark, float distance) {
    const glm::vec3 move = mark.position - m_last;
    const float length = glm::length(move);
    if (!(length > 0.0f))
      return std::abs(m_turn);
    const glm::vec3 direction = move / length;
    if (m_direction != glm::vec3(0.0f)) {
      const float sine = glm::dot(glm::cross(m_direction, direction), mark.normal);
      m_turn = m_turn * std::max(1.0f - length / distance, 0.0f) +
               std::asin(std::clamp(sine, -1.0f, 1.0f));
    }
    m_direction = direction;
    m_last = mark.position;
    return std::abs(m_turn);
  }

 private:
  glm::vec3 m_last;
  glm::vec3 m_direction{0.0f};
  float m_turn = 0.0f;
};

/// Lays one cube's strokes.
class StrokeLayout::Placer {
 public:
  Placer(const StrokeLayout& layout, int level, StrokeSpacing& taken)
      : m_layout(layout),
        m_distance(layout.spacing(level)),
        m_half(layout.reach(level)),
        m_taken(taken) {
    const float edge = layout.surface().meanEdge;
    m_step = std::clamp(edge, finestStep * m_distance, step * m_distance);
  }

  void place(const PlacedSeed& seed) {
    const StrokeSpacing::Mark start = m_layout.markAt(seed.at);
    if (m_taken.room(start) < roomToStart)
      return;
    m_points.clear();
    m_marks.clear();
    if (m_layout.length() > 0.0f) {
      Arm behind(*this, seed.at, start, false);
      Arm ahead(*this, seed.at, start, true);
      // Both ways advance at once, so that a mirror, which may swap them, mirrors where they meet.
      while (int(behind.step()) + int(ahead.step()) > 0)
        for (Arm* arm : {&behind, &ahead})
          arm->leaveMark(m_marks);
      if (behind.gone() + ahead.gone() < shortest * m_distance)
        return;
      m_points.assign(behind.points().rbegin(), behind.points().rend());
      m_points.push_back(seed.at);
      m_points.insert(m_points.end(), ahead.points().begin(), ahead.points().end());
      m_seedPoint = std::uint32_t(behind.points().size());
    } else {
      m_points.push_back(seed.at);
      m_seedPoint = 0;
    }
    keep(seed);
  }

  LaidTile take() {
    m_tile.points.shrink_to_fit();
    m_tile.strokes.shrink_to_fit();
    return std::move(m_tile);
  }

 private:
  struct Own {
    StrokeSpacing::Mark mark;
    float place;  ///< mm from the seed along the stroke, negative one way
  };

  /// One half of a stroke, from the seed on.
  class Arm {
   public:
    Arm(const Placer& placer, const SurfacePoint& seed, const StrokeSpacing::Mark& start,
        bool along)
        : m_placer(placer),
          m_walk(placer.m_layout.surface(), placer.m_layout.m_neighbours,
                 placer.m_layout.m_directions, seed),
          m_bend(start.position),
          m_sign(along ? 1.0f : -1.0f),
          m_grows(m_walk.start(along)) {}

    float gone() const { return m_gone; }
    const std::vector<SurfacePoint>& points() const { return m_points; }

    /// Takes a step; returns false when the half stroke has ended.
    bool step() {
      const float length = m_placer.m_step;
      m_grows = m_grows && m_gone + length <= m_placer.m_half;
      if (!m_grows)
        return false;
      const bool more = m_walk.advance(length);
      const StrokeSpacing::Mark mark = m_placer.m_layout.markAt(m_walk.at());
      if (m_placer.m_taken.room(mark) < roomToGoOn ||
          m_placer.meetsItself(mark, m_sign * (m_gone + length)) ||
          m_bend.after(mark, m_placer.m_distance) > sharpestBend)
        return m_grows = false;
      m_gone += length;
      m_points.push_back(m_walk.at());
      m_last = mark;
      m_grows = more;
      return true;
    }

    void leaveMark(std::vector<Own>& marks) {
      if (m_gone - m_marked < markStep * m_placer.m_distance)
        return;
      marks.push_back({m_last, m_sign * m_gone});
      m_marked = m_gone;
    }

   private:
    const Placer& m_placer;
    SurfaceWalk m_walk;
    Bend m_bend;
    float m_sign;
    bool m_grows;
    float m_gone = 0.0f;
    float m_marked = 0.0f;
    StrokeSpacing::Mark m_last;
    std::vector<SurfacePoint> m_points;
  };

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

  const StrokeLayout& m_layout;
  float m_distance;
  float m_half;  ///< mm, the longest half of a stroke
  float m_step;
  StrokeSpacing& m_taken;
  std::vector<SurfacePoint> m_points;
  std::vector<Own> m_marks;
  std::uint32_t m_seedPoint = 0;
  LaidTile m_tile;
};

bool touches(const model::Sphere& sphere, const model::Box& box) {
  const glm::vec3 away = sphere.centre - glm::clamp(sphere.centre, box.low, box.high);
  return glm::dot(away, away) <= sphere.radius * sphere.radius;
}

StrokeLayout::StrokeLayout(model::SurfacePtr surface, float length)
    : m_surface(std::move(surface)),
      m_neighbours(*m_surface->mesh),
      m_directions(*m_surface),
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
  const float second = float(point.second) / 65535.0f;
  const float third = float(point.third) / 65535.0f;
  return {point.triangle, {1.0f - second - third, second, third}};
}

glm::vec3 StrokeLayout::position(const LaidPoint& point) const {
  return valueAt(*m_surface->mesh, m_surface->mesh->positions(), at(point));
}

void StrokeLayout::beginView() {
  const std::lock_guard lock(m_mutex);
  ++m_view;
  if (m_points <= fewPoints)
    return;
  std::erase_if(m_tiles, [this](const auto& entry) {
    const bool old = m_view - entry.second.lastView > viewsKept;
    m_points -= old ? entry.second.tile->points.size() : 0;
    return old;
  });
}

std::shared_ptr<const LaidTile> StrokeLayout::tile(const LaidCell& cell) {
  const std::lock_guard lock(m_mutex);
  return found(cell);
}

std::shared_ptr<const LaidTile> StrokeLayout::found(const LaidCell& cell) {
  auto known = m_tiles.find(cell);
  if (known == m_tiles.end()) {
    auto laid = std::make_shared<const LaidTile>(lay(cell));
    m_points += laid->points.size();
    known = m_tiles.emplace(cell, KeptTile{std::move(laid)}).first;
  }
  known->second.lastView = m_view;
  return known->second.tile;
}

LaidTile StrokeLayout::lay(const LaidCell& cell) {
  const model::Box box = home(cell);
  std::vector<std::uint32_t> clusters;
  for (std::size_t c = 0; c < m_surface->clusters.items.size(); ++c)
    if (touches(m_surface->clusters.items[c].bounds, box))
      clusters.push_back(std::uint32_t(c));
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
    const std::shared_ptr<const LaidTile> laid = found(other);
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
                        StrokeSpacing& taken) const {
  StrokeSpacing::Mark last = markAt(at(tile.points[stroke.first]));
  taken.add(last);
  for (std::uint32_t i = stroke.first + 1; i < stroke.first + stroke.count; ++i) {
    const StrokeSpacing::Mark next = markAt(at(tile.points[i]));
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
