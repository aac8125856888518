// SPDX-License-Identifier: Apache-2.0
#include "model/geometry/nearest_point.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

namespace sline::model {

namespace {

using Weights = std::array<double, 2>;

/// Returns the weight of b at the point on the segment from a to b that is nearest to p.
double shareOnSegment(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& p) {
  const glm::dvec3 along = b - a;
  const double length = glm::dot(along, along);
  return length > 0.0 ? std::clamp(glm::dot(p - a, along) / length, 0.0, 1.0) : 0.0;
}

glm::dvec3 at(const std::array<glm::dvec3, 3>& t, const Weights& w) {
  return t[0] + w[0] * (t[1] - t[0]) + w[1] * (t[2] - t[0]);
}

/// Returns the weights of the foot of the perpendicular where that lies inside, else of the nearest
/// point of the three sides.
Weights nearestIn(const std::array<glm::dvec3, 3>& t, const glm::dvec3& p) {
  const glm::dvec3 u = t[1] - t[0];
  const glm::dvec3 v = t[2] - t[0];
  const glm::dvec3 d = p - t[0];
  // These are the normal equations of |d − a u − b v|² → min.
  const double uu = glm::dot(u, u);
  const double uv = glm::dot(u, v);
  const double vv = glm::dot(v, v);
  const double determinant = uu * vv - uv * uv;
  if (determinant > 1e-14 * uu * vv) {
    const double a = (vv * glm::dot(d, u) - uv * glm::dot(d, v)) / determinant;
    const double b = (uu * glm::dot(d, v) - uv * glm::dot(d, u)) / determinant;
    if (a >= 0.0 && b >= 0.0 && a + b <= 1.0)
      return {a, b};
  }
  const double first = shareOnSegment(t[0], t[1], p);
  const double second = shareOnSegment(t[1], t[2], p);
  const double third = shareOnSegment(t[2], t[0], p);
  const std::array<Weights, 3> sides{{{first, 0.0}, {1.0 - second, second}, {0.0, 1.0 - third}}};
  return *std::min_element(sides.begin(), sides.end(), [&](const Weights& a, const Weights& b) {
    const glm::dvec3 toA = at(t, a) - p;
    const glm::dvec3 toB = at(t, b) - p;
    return glm::dot(toA, toA) < glm::dot(toB, toB);
  });
}

std::array<glm::dvec3, 3> cornersOf(const Mesh& mesh, std::uint32_t triangle) {
  const auto positions = mesh.positions();
  const Triangle& corners = mesh.triangles()[triangle];
  return {glm::dvec3(positions[corners[0]]), glm::dvec3(positions[corners[1]]),
          glm::dvec3(positions[corners[2]])};
}

}  // namespace

PointOnMesh nearestPointIn(const Mesh& mesh, std::uint32_t triangle, const glm::vec3& p) {
  const std::array<glm::dvec3, 3> t = cornersOf(mesh, triangle);
  const Weights weights = nearestIn(t, glm::dvec3(p));
  return {triangle, {float(weights[0]), float(weights[1])}, glm::vec3(at(t, weights))};
}

std::optional<PointOnMesh> nearestPoint(const Mesh& mesh, const glm::vec3& p) {
  std::optional<PointOnMesh> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t i = 0; i < mesh.triangleCount(); ++i) {
    const std::array<glm::dvec3, 3> t = cornersOf(mesh, i);
    const Weights weights = nearestIn(t, glm::dvec3(p));
    const glm::dvec3 place = at(t, weights);
    const glm::dvec3 away = place - glm::dvec3(p);
    if (const double square = glm::dot(away, away); square < least) {
      least = square;
      nearest = PointOnMesh{i, {float(weights[0]), float(weights[1])}, glm::vec3(place)};
    }
  }
  return nearest;
}

}  // namespace sline::model
