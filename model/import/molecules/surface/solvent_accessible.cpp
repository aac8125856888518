// SPDX-License-Identifier: Apache-2.0
#include "model/import/molecules/surface/solvent_accessible.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "model/base/parallel.h"

namespace sline::model {

namespace {

constexpr double cellSize = 4.0;
/// Matter with all its hydrogens has about ten in 64 Å³.
constexpr std::size_t mostInCell = 40;
constexpr double fullTurn = 2.0 * std::numbers::pi;

/// Takes the angles from `low` to `high` (within one turn, low < high) out of the spans.
void takeOut(std::vector<std::pair<double, double>>& spans, double low, double high) {
  std::vector<std::pair<double, double>> left;
  for (const auto& [from, to] : spans) {
    if (high <= from || low >= to) {
      left.emplace_back(from, to);
      continue;
    }
    if (from < low)
      left.emplace_back(from, low);
    if (high < to)
      left.emplace_back(high, to);
  }
  spans = std::move(left);
}

/// Takes out the angles within `half` of `middle`, at most one turn apart.
void takeOutAround(std::vector<std::pair<double, double>>& spans, double middle, double half) {
  double low = middle - half;
  low -= fullTurn * std::floor(low / fullTurn);
  const double high = low + 2.0 * half;
  takeOut(spans, low, std::min(high, fullTurn));
  if (high > fullTurn)
    takeOut(spans, 0.0, high - fullTurn);
}

/// Returns two unit vectors that are perpendicular to n and to each other.
std::pair<glm::dvec3, glm::dvec3> frameOf(const glm::dvec3& n) {
  const glm::dvec3 other =
      std::abs(n.x) < 0.6 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
  const glm::dvec3 u = glm::normalize(glm::cross(n, other));
  return {u, glm::cross(n, u)};
}

}  // namespace

bool ExposedArc::holds(double angle) const {
  const double a = angle < 0.0 ? angle + fullTurn : angle;
  return std::any_of(spans.begin(), spans.end(),
                     [a](const auto& span) { return a >= span.first && a <= span.second; });
}

bool ExposedArc::isWhole() const {
  return spans.size() == 1 && spans.front() == std::pair(0.0, fullTurn);
}

SolventAccessible::Cell SolventAccessible::cellOf(const glm::dvec3& p) const {
  return {std::int64_t(std::floor(p.x / cellSize)), std::int64_t(std::floor(p.y / cellSize)),
          std::int64_t(std::floor(p.z / cellSize))};
}

bool SolventAccessible::sortIntoCells() {
  m_cells.clear();
  m_largest = 0.0;
  for (std::uint32_t i = 0; i < m_balls.size(); ++i) {
    m_cells.emplace_back(cellOf(m_balls[i].centre), i);
    m_largest = std::max(m_largest, m_balls[i].radius);
  }
  std::sort(m_cells.begin(), m_cells.end());
  for (std::size_t i = mostInCell; i < m_cells.size(); ++i)
    if (m_cells[i].first == m_cells[i - mostInCell].first)
      return false;
  return true;
}

std::vector<std::uint32_t> SolventAccessible::ballsNear(const glm::dvec3& low,
                                                        const glm::dvec3& high,
                                                        double reach) const {
  const double margin = reach + m_largest;
  const Cell first = cellOf(low - margin);
  const Cell last = cellOf(high + margin);
  std::vector<std::uint32_t> found;
  for (std::int64_t x = first[0]; x <= last[0]; ++x)
    for (std::int64_t y = first[1]; y <= last[1]; ++y) {
      auto at = std::lower_bound(m_cells.begin(), m_cells.end(),
                                 std::pair(Cell{x, y, first[2]}, std::uint32_t(0)));
      for (; at != m_cells.end() && at->first <= Cell{x, y, last[2]}; ++at) {
        const Ball& ball = m_balls[at->second];
        const glm::dvec3 off = ball.centre - glm::clamp(ball.centre, low, high);
        const double wanted = reach + ball.radius;
        if (glm::dot(off, off) < wanted * wanted)
          found.push_back(at->second);
      }
    }
  return found;
}

bool SolventAccessible::findNeighbours(const std::function<bool()>& goesOn) {
  std::vector<std::vector<std::uint32_t>> lists(m_balls.size());
  std::atomic<bool> stopped = false;
  parallelFor(m_balls.size(), 256, [&](std::size_t i) {
    if (stopped || (i % 1024 == 0 && !goesOn())) {
      stopped = true;
      return;
    }
    const Ball& ball = m_balls[i];
    std::vector<std::pair<double, std::uint32_t>> near;
    for (const std::uint32_t k : ballsNear(ball.centre, ball.centre, ball.radius))
      if (k != i)
        near.emplace_back(glm::length(m_balls[k].centre - ball.centre), k);
    std::sort(near.begin(), near.end());
    for (const auto& [distance, k] : near)
      lists[i].push_back(k);
  });
  m_neighbours.clear();
  m_neighbourStart.assign(1, 0);
  for (const auto& list : lists) {
    m_neighbours.insert(m_neighbours.end(), list.begin(), list.end());
    m_neighbourStart.push_back(m_neighbours.size());
  }
  return !stopped;
}

std::span<const std::uint32_t> SolventAccessible::neighboursOf(std::size_t ball) const {
  return std::span(m_neighbours)
      .subspan(m_neighbourStart[ball], m_neighbourStart[ball + 1] - m_neighbourStart[ball]);
}

void SolventAccessible::leaveOutSwallowed() {
  std::vector<Ball> kept;
  for (std::size_t i = 0; i < m_balls.size(); ++i) {
    const Ball& ball = m_balls[i];
    const auto near = neighboursOf(i);
    const bool swallowed = std::any_of(near.begin(), near.end(), [&](std::uint32_t k) {
      const Ball& other = m_balls[k];
      // The first of two equal balls stays.
      return glm::length(other.centre - ball.centre) + ball.radius <= other.radius + 1e-6 &&
             (other.radius > ball.radius + 1e-6 || k < i);
    });
    if (!swallowed)
      kept.push_back(ball);
  }
  m_balls = std::move(kept);
}

std::optional<ExposedArc> SolventAccessible::arcOf(std::size_t a, std::size_t b) const {
  const Ball& one = m_balls[a];
  const Ball& two = m_balls[b];
  const glm::dvec3 between = two.centre - one.centre;
  const double apart = glm::length(between);
  const double along =
      (apart * apart + one.radius * one.radius - two.radius * two.radius) / (2.0 * apart);
  const double squared = one.radius * one.radius - along * along;
  if (!(squared > 1e-12))
    return std::nullopt;
  ExposedArc arc;
  arc.other = std::uint32_t(b);
  const glm::dvec3 axis = between / apart;
  arc.centre = one.centre + along * axis;
  arc.radius = std::sqrt(squared);
  std::tie(arc.u, arc.v) = frameOf(axis);
  arc.spans.emplace_back(0.0, fullTurn);
  for (const std::uint32_t k : neighboursOf(a)) {
    if (k == b)
      continue;
    // A point is covered where |c + ρ(u cos φ + v sin φ) − c_k|² < R_k².
    const glm::dvec3 off = m_balls[k].centre - arc.centre;
    const double x = glm::dot(off, arc.u);
    const double y = glm::dot(off, arc.v);
    const double most = 2.0 * arc.radius * std::hypot(x, y);
    const double least = glm::dot(off, off) + squared - m_balls[k].radius * m_balls[k].radius;
    if (least >= most)
      continue;
    if (least <= -most)
      return std::nullopt;
    takeOutAround(arc.spans, std::atan2(y, x), std::acos(least / most));
    if (arc.spans.empty())
      return std::nullopt;
  }
  return arc;
}

void SolventAccessible::findArcs(std::size_t ball) {
  for (const std::uint32_t other : neighboursOf(ball))
    if (other > ball)
      if (std::optional<ExposedArc> arc = arcOf(ball, other))
        m_arcs[ball].push_back(std::move(*arc));
}

std::optional<SolventAccessible> SolventAccessible::of(std::vector<Ball> balls,
                                                       const std::function<bool()>& goesOn) {
  SolventAccessible surface;
  surface.m_balls = std::move(balls);
  if (!surface.sortIntoCells() || !surface.findNeighbours(goesOn))
    return std::nullopt;
  const std::size_t all = surface.m_balls.size();
  surface.leaveOutSwallowed();
  if (surface.m_balls.size() != all &&
      (!surface.sortIntoCells() || !surface.findNeighbours(goesOn)))
    return std::nullopt;
  const std::size_t count = surface.m_balls.size();
  surface.m_arcs.resize(count);
  std::atomic<bool> stopped = false;
  parallelFor(count, 64, [&](std::size_t i) {
    if (stopped || (i % 256 == 0 && !goesOn()))
      stopped = true;
    else
      surface.findArcs(i);
  });
  if (stopped)
    return std::nullopt;
  // A sphere is exposed where part of its edge is, or where it has no edge.
  surface.m_exposed.assign(count, 0);
  for (std::size_t i = 0; i < count; ++i) {
    if (surface.neighboursOf(i).empty() || !surface.m_arcs[i].empty())
      surface.m_exposed[i] = 1;
    for (const ExposedArc& arc : surface.m_arcs[i])
      surface.m_exposed[arc.other] = 1;
  }
  return surface;
}

double SolventAccessible::roughArea() const {
  constexpr int samples = 48;
  const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
  double area = 0.0;
  for (std::size_t i = 0; i < m_balls.size(); ++i) {
    if (m_exposed[i] == 0)
      continue;
    const Ball& ball = m_balls[i];
    int free = 0;
    for (int k = 0; k < samples; ++k) {
      const double z = 1.0 - (2.0 * k + 1.0) / samples;
      const double r = std::sqrt(1.0 - z * z);
      const glm::dvec3 n(r * std::cos(golden * k), r * std::sin(golden * k), z);
      free += isFree(ball.centre + ball.radius * n, i) ? 1 : 0;
    }
    area += 4.0 * std::numbers::pi * ball.radius * ball.radius * free / samples;
  }
  return area;
}

std::span<const ExposedArc> SolventAccessible::arcsOf(std::size_t ball) const {
  return m_arcs[ball];
}

bool SolventAccessible::isFree(const glm::dvec3& p, std::size_t ball) const {
  const auto near = neighboursOf(ball);
  return std::none_of(near.begin(), near.end(), [&](std::uint32_t k) {
    const glm::dvec3 off = p - m_balls[k].centre;
    return glm::dot(off, off) < m_balls[k].radius * m_balls[k].radius;
  });
}

}  // namespace sline::model
