// SPDX-License-Identifier: Apache-2.0
#include "render/lines/hatching/stroke_placer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <utility>

namespace sline::render {

namespace {

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
// A stroke that comes round to itself, after this many distances, ends as it would at another
// stroke.
constexpr float roundTrip = 2.0f;
// A stroke may not turn within the surface by more than this many radians in about a distance:
// around the field's singular points strokes would curl.
constexpr float sharpestBend = 0.7f;
// Strokes follow directions that were estimated triangle by triangle: so often each point is moved
// half way to the middle between its neighbours.
constexpr int evenings = 3;
// How far numbers of a unit normal are off in the rows of a tile.
constexpr float rowRounding = 1.0f / LaidTile::normalSteps;

/// Returns the shape operator there.
std::array<float, 6> bendingAt(const model::Surface& surface, const SurfacePoint& at) {
  const model::Triangle& t = surface.mesh->triangles()[at.triangle];
  std::array<float, 6> sum{};
  for (std::size_t corner = 0; corner < 3; ++corner) {
    const std::array<float, 6> s = model::shapeOperator(surface.vertices[t[corner]]);
    for (std::size_t i = 0; i < sum.size(); ++i)
      sum[i] += at.barycentric[glm::length_t(corner)] * s[i];
  }
  return sum;
}

/// Takes a stroke's kinks away: its points move along the surface only, and its ends stay.
void even(std::span<StrokeSpacing::Mark> marks) {
  for (int round = 0; round < evenings; ++round) {
    glm::vec3 before = marks.front().position;
    for (std::size_t i = 1; i + 1 < marks.size(); ++i) {
      const glm::vec3 here = marks[i].position;
      const glm::vec3& n = marks[i].normal;
      const glm::vec3 move = 0.25f * (before + marks[i + 1].position) - 0.5f * here;
      marks[i].position += move - glm::dot(move, n) * n;
      before = here;
    }
  }
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

/// One half of a stroke, from the seed on.
class StrokeLayout::Placer::Arm {
 public:
  Arm(const Placer& placer, const SurfacePoint& seed, const StrokeSpacing::Mark& start, bool along)
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

StrokeLayout::Placer::Placer(const StrokeLayout& layout, int level, StrokeSpacing& taken)
    : m_layout(layout),
      m_distance(layout.spacing(level)),
      m_half(layout.reach(level)),
      m_taken(taken) {
  const float edge = layout.surface().meanEdge;
  m_step = std::clamp(edge, finestStep * m_distance, step * m_distance);
}

void StrokeLayout::Placer::place(const PlacedSeed& seed) {
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

LaidTile StrokeLayout::Placer::take() {
  m_tile.points.shrink_to_fit();
  m_tile.strokes.shrink_to_fit();
  m_tile.positions.shrink_to_fit();
  m_tile.shape.shrink_to_fit();
  return std::move(m_tile);
}

bool StrokeLayout::Placer::meetsItself(const StrokeSpacing::Mark& mark, float place) const {
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

LaidPoint StrokeLayout::Placer::packed(const SurfacePoint& at) const {
  return {.slot = m_layout.m_slots[at.triangle],
          .second = std::uint16_t(std::lround(65535.0f * at.barycentric.y)),
          .third = std::uint16_t(std::lround(65535.0f * at.barycentric.z))};
}

void StrokeLayout::Placer::keep(const PlacedSeed& seed) {
  LaidStroke stroke{.seed = seed.name,
                    .first = std::uint32_t(m_tile.points.size()),
                    .count = std::uint32_t(m_points.size()),
                    .seedPoint = m_seedPoint,
                    .firstRow = m_rows};
  for (const SurfacePoint& at : m_points)
    m_tile.points.push_back(packed(at));
  describe(stroke);
  m_tile.strokes.push_back(stroke);
  mark(m_tile, stroke, m_distance, m_taken);
}

/// Appends the rows of the stroke's points, and bounds them.
void StrokeLayout::Placer::describe(LaidStroke& stroke) {
  const std::size_t count = stroke.count;
  const std::size_t row = stroke.rowLength();
  m_rows += stroke.rowLength();
  m_tile.positions.resize(3 * std::size_t(m_rows));
  m_tile.shape.resize(LaidTile::shapeRows * m_rows);
  float* positions = m_tile.positions.data() + 3 * std::size_t(stroke.firstRow);
  std::int16_t* shape = m_tile.shape.data() + LaidTile::shapeRows * stroke.firstRow;
  const auto rounded = [](float number) { return std::int16_t(std::lround(number)); };
  m_bendings.resize(count);
  m_described.clear();
  for (std::size_t i = 0; i < count; ++i)
    m_described.push_back(m_layout.markAt(m_layout.at(m_tile.points[stroke.first + i])));
  even(m_described);
  model::Box box;
  float largest = 0.0f;
  glm::vec3 sum(0.0f);
  for (std::size_t i = 0; i < count; ++i) {
    const StrokeSpacing::Mark& mark = m_described[i];
    box.add(mark.position);
    sum += mark.normal;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      positions[axis * row + i] = mark.position[glm::length_t(axis)];
      shape[axis * row + i] = rounded(LaidTile::normalSteps * mark.normal[glm::length_t(axis)]);
    }
    m_bendings[i] = bendingAt(m_layout.surface(), m_layout.at(m_tile.points[stroke.first + i]));
    for (const float number : m_bendings[i])
      largest = std::max(largest, std::abs(number));
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
    std::fill(positions + axis * row + count, positions + (axis + 1) * row,
              positions[axis * row + count - 1]);
  stroke.bounds = {box.centre(), 0.5f * glm::length(box.size())};
  stroke.bendingStep = largest / LaidTile::normalSteps;
  const float steps = largest > 0.0f ? LaidTile::normalSteps / largest : 0.0f;
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = 0; k < m_bendings[i].size(); ++k)
      shape[(3 + k) * row + i] = rounded(steps * m_bendings[i][k]);
  const float length = glm::length(sum);
  if (!(length > 0.0f))
    return;
  stroke.cone = {.axis = sum / length, .cosine = 1.0f};
  // Rounding may leave the cone.
  for (std::size_t i = 0; i < count; ++i)
    stroke.cone.cosine =
        std::min(stroke.cone.cosine,
                 glm::dot(stroke.cone.axis, m_tile.normal(stroke, i)) - 2.0f * rowRounding);
}

}  // namespace sline::render
