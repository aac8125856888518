// SPDX-License-Identifier: Apache-2.0
// Settles the tube by position-based dynamics: in each round every rule moves the points part of
// the way to where it holds.
#include "model/sculpting/coil.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace sline::model {

namespace {
using Points = std::vector<glm::vec3>;

Points evenlySpaced(std::span<const glm::vec3> path, float spacing) {
  std::vector<Curve::Knot> through;
  for (const glm::vec3& p : path)
    through.push_back({glm::vec4(p, 1.0f)});
  const Curve curve(through, 0.25f * spacing);
  Points points{path.front()};
  float due = spacing;
  float along = 0.0f;
  for (std::size_t i = 1; i < curve.knots().size(); ++i) {
    const glm::vec3 at(curve.knots()[i].main);
    along += glm::distance(at, glm::vec3(curve.knots()[i - 1].main));
    if (along < due)
      continue;
    points.push_back(at);
    due += spacing;
  }
  points.push_back(path.back());
  return points;
}

void keepSpacing(Points& points, float spacing) {
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const glm::vec3 d = points[i + 1] - points[i];
    const float length = std::max(glm::length(d), 1e-3f);
    const glm::vec3 move = 0.5f * (length - spacing) / length * d;
    if (i > 0)
      points[i] += move;
    if (i + 2 < points.size())
      points[i + 1] -= move;
  }
}

/// Keeps each bend no tighter than one of `radius`: the ends of each stretch of `span` steps stay
/// as far apart as on such a bend.
void keepBendsOpen(Points& points, float spacing, float radius, std::size_t span) {
  const float least = 2.0f * radius * std::sin(0.5f * float(span) * spacing / radius);
  for (std::size_t i = 1; i + span + 1 < points.size(); ++i) {
    const glm::vec3 d = points[i + span] - points[i];
    const float length = std::max(glm::length(d), 1e-3f);
    if (length >= least)
      continue;
    const glm::vec3 move = 0.25f * (least - length) / length * d;
    points[i] -= move;
    points[i + span] += move;
  }
}

/// Returns the share of points into which another stretch of the tube presses by more than a
/// twelfth.
float crowding(const Points& points, float apart, std::size_t alongTube) {
  std::size_t pressed = 0;
  const float least = 0.92f * apart;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto close = [&](std::size_t k) {
      const glm::vec3 d = points[k] - points[i];
      return glm::dot(d, d) < least * least;
    };
    bool found = false;
    for (std::size_t k = 0; k + alongTube <= i && !found; ++k)
      found = close(k);
    for (std::size_t k = i + alongTube; k < points.size() && !found; ++k)
      found = close(k);
    pressed += found;
  }
  return float(pressed) / float(points.size());
}

/// Moves each point a little towards the middle of its neighbours two steps away.
void straighten(Points& points) {
  const Points before = points;
  for (std::size_t i = 2; i + 2 < points.size(); ++i)
    points[i] += 0.06f * (0.5f * (before[i - 2] + before[i + 2]) - before[i]);
}

void pushApart(Points& points, float apart, std::size_t alongTube) {
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t k = i + alongTube; k < points.size(); ++k) {
      const glm::vec3 d = points[k] - points[i];
      const float squared = glm::dot(d, d);
      if (squared >= apart * apart || squared < 1e-6f)
        continue;
      const float length = std::sqrt(squared);
      const glm::vec3 move = 0.35f * (apart - length) / length * d;
      if (i > 0)
        points[i] -= move;
      if (k + 1 < points.size())
        points[k] += move;
    }
}

void giveWay(Points& points, const Field& keepOut, float clearance) {
  constexpr float h = 1.0f;
  for (std::size_t i = 3; i + 3 < points.size(); ++i) {
    const glm::vec3 p = points[i];
    const float d = keepOut(p);
    if (d >= clearance)
      continue;
    const glm::vec3 g(keepOut(p + glm::vec3(h, 0, 0)) - d, keepOut(p + glm::vec3(0, h, 0)) - d,
                      keepOut(p + glm::vec3(0, 0, h)) - d);
    const float steepness = glm::length(g);
    if (steepness > 1e-3f)
      points[i] += std::min(0.5f * (clearance - d), 3.0f) / steepness * g;
  }
}
}  // namespace

std::vector<glm::vec3> settledCoil(std::span<const glm::vec3> path, const CoilRules& rules) {
  Points points(path.begin(), path.end());
  // Points closer along the tube than half a turn of the tightest bend count as neighbours.
  const auto neighbours = std::size_t(std::ceil(3.1f * rules.radius / rules.spacing));
  const int growing = rules.stages - rules.settling;
  for (int stage = 0; stage < rules.stages; ++stage) {
    points = evenlySpaced(points, rules.spacing);
    // Where there is already too little room the tube gets shorter instead.
    const float crowd = crowding(points, 2.0f * rules.radius, neighbours);
    const float growth =
        stage < growing ? (crowd < 0.15f ? rules.growth : 1.0f) : (crowd < 0.01f ? 1.0f : 0.97f);
    for (int round = 0; round < rules.rounds; ++round) {
      straighten(points);
      for (const std::size_t span : {neighbours / 2, neighbours - 1})
        keepBendsOpen(points, rules.spacing, 1.3f * rules.radius, span);
      pushApart(points, 2.0f * rules.radius, neighbours);
      if (round % 2 == 0)
        giveWay(points, rules.keepOut, rules.radius);
      keepSpacing(points, growth * rules.spacing);
    }
  }
  return points;
}

}  // namespace sline::model
