// SPDX-License-Identifier: Apache-2.0
// Finds the sphere by pivoting as in B. Gärtner, "Fast and Robust Smallest Enclosing Balls" (ESA
// 1999): a small support set is solved exactly and the farthest point outside joins it, until no
// point is outside.
#include "model/geometry/bounding_sphere.h"

#include <algorithm>
#include <array>
#include <bit>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <vector>

namespace sline::model {

namespace {
struct Ball {
  glm::dvec3 centre{0.0};
  double squaredRadius = -1.0;
  bool contains(const glm::dvec3& p) const {
    return glm::dot(p - centre, p - centre) <= squaredRadius * (1.0 + 1e-10) + 1e-300;
  }
};

/// Finds the smallest ball with all given points (1 to 4) on its surface; returns false where they
/// are dependent. Its centre is q0 + Σ λi·(qi − q0), and |centre − qi| = |centre − q0| is linear in
/// λ.
bool circumscribed(const std::vector<glm::dvec3>& q, Ball& ball) {
  const std::size_t n = q.size() - 1;
  glm::dmat3 gram(1.0);
  glm::dvec3 right(0.0);
  std::array<glm::dvec3, 3> d{};
  double scale = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    d[i] = q[i + 1] - q[0];
    scale = std::max(scale, glm::dot(d[i], d[i]));
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j)
      gram[glm::length_t(j)][glm::length_t(i)] = 2.0 * glm::dot(d[i], d[j]) / scale;
    right[glm::length_t(i)] = glm::dot(d[i], d[i]) / scale;
  }
  if (n > 0 && !(std::abs(glm::determinant(gram)) > 1e-12))
    return false;
  const glm::dvec3 weights = n > 0 ? glm::inverse(gram) * right : glm::dvec3(0.0);
  glm::dvec3 offset(0.0);
  for (std::size_t i = 0; i < n; ++i)
    offset += weights[glm::length_t(i)] * d[i];
  ball.centre = q[0] + offset;
  ball.squaredRadius = glm::dot(offset, offset);
  return true;
}

/// Returns the smallest ball around at most five points, by trying every subset as its support.
Ball smallestOfFew(const std::vector<glm::dvec3>& points, std::vector<glm::dvec3>& support) {
  Ball best;
  std::vector<glm::dvec3> subset;
  for (unsigned mask = 1; mask < (1u << points.size()); ++mask) {
    if (std::popcount(mask) > 4)
      continue;
    subset.clear();
    for (std::size_t i = 0; i < points.size(); ++i)
      if (mask & (1u << i))
        subset.push_back(points[i]);
    Ball ball;
    if (!circumscribed(subset, ball))
      continue;
    if (best.squaredRadius >= 0.0 && ball.squaredRadius >= best.squaredRadius)
      continue;
    if (std::all_of(points.begin(), points.end(),
                    [&](const auto& p) { return ball.contains(p); })) {
      best = ball;
      support = subset;
    }
  }
  return best;
}
}  // namespace

Sphere smallestBoundingSphere(std::span<const glm::vec3> points) {
  if (points.empty())
    return {};
  std::vector<glm::dvec3> support{glm::dvec3(points[0])};
  Ball ball{.centre = support[0], .squaredRadius = 0.0};
  for (int round = 0; round < 100; ++round) {
    double farthest = -1.0;
    glm::dvec3 pivot(0.0);
    for (const glm::vec3& p : points) {
      const glm::dvec3 d = glm::dvec3(p) - ball.centre;
      const double squared = glm::dot(d, d);
      if (squared > farthest) {
        farthest = squared;
        pivot = p;
      }
    }
    if (farthest <= ball.squaredRadius * (1.0 + 1e-6))
      break;
    std::vector<glm::dvec3> candidates = support;
    candidates.push_back(pivot);
    const Ball grown = smallestOfFew(candidates, support);
    if (!(grown.squaredRadius > ball.squaredRadius))
      break;
    ball = grown;
  }
  return {.centre = glm::vec3(ball.centre), .radius = float(std::sqrt(ball.squaredRadius))};
}

}  // namespace sline::model
