// SPDX-License-Identifier: Apache-2.0
// Position-based: in each round every rule moves the points part of the way to where it holds.
#include "model/demo/coil.h"

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

/// Each point a little towards the middle of its neighbours two steps away.
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
      const glm::vec3 move = 0.25f * (apart - length) / length * d;
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
  // Nearer along the tube than half a turn of the tightest bend, points are neighbours.
  const auto neighbours = std::size_t(std::ceil(3.1f * rules.radius / rules.spacing));
  for (int stage = 0; stage < rules.stages; ++stage) {
    points = evenlySpaced(points, rules.spacing);
    const float growth = stage + 2 < rules.stages ? rules.growth : 1.0f;
    for (int round = 0; round < rules.rounds; ++round) {
      straighten(points);
      pushApart(points, 2.0f * rules.radius, neighbours);
      if (round % 2 == 0)
        giveWay(points, rules.keepOut, rules.radius);
      keepSpacing(points, growth * rules.spacing);
    }
  }
  return points;
}

}  // namespace sline::model
