// SPDX-License-Identifier: Apache-2.0
// Follows a field that is linear over a triangle, in closed form (METHOD §8). With the corners p1,
// p2, p3 a place is p1 + α·(p2 − p1) + β·(p3 − p1), and the field there A·(α, β)ᵀ + e1 in the same
// coordinates.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <optional>

namespace sline::render {

/// Holds a linear field and its streamlines. The streamline from c0 is
/// c(t) = exp(At)·c0 + I(t)·e1 with I(t) = ∫₀ᵗ exp(As) ds, and as exp(At) = 1 + I(t)·A, that is
/// c0 + I(t)·(A·c0 + e1): for any A, singular ones too.
class LinearFlow {
 public:
  /// Takes the field's values at the three corners, each in components of p2 − p1 and p3 − p1.
  LinearFlow(const glm::dvec2& e1, const glm::dvec2& e2, const glm::dvec2& e3);

  glm::dvec2 velocity(const glm::dvec2& at) const;
  /// Returns where the streamline from `from` is at the time t.
  glm::dvec2 at(const glm::dvec2& from, double t) const;

 private:
  /// Matrices row by row.
  using Matrix = std::array<double, 4>;
  glm::dvec2 series(const glm::dvec2& velocity, double t) const;
  Matrix integral(double t) const;
  /// Returns x·I + y·(A − m·I).
  Matrix combined(double x, double y) const;

  Matrix m_a;
  glm::dvec2 m_e;
  double m_mean;     ///< m = tr A / 2
  double m_square;   ///< q² = m² − det A
  double m_largest;  ///< bounds what A does to any vector
};

/// Names the sides of a triangle that a streamline may leave through by the corner that lies
/// opposite: 0 where 1 − α − β = 0, 1 where α = 0, 2 where β = 0.
struct TriangleExit {
  double time = 0.0;
  glm::dvec2 at{0.0};
  int side = 0;
};

/// Returns when within `longest` the streamline from `from`, a place in the triangle, leaves it.
/// Between both times it must be nearly straight.
std::optional<TriangleExit> exitWithin(const LinearFlow& flow, const glm::dvec2& from,
                                       double longest);

/// Returns the barycentric coordinates of a place.
inline std::array<double, 3> barycentric(const glm::dvec2& at) {
  return {1.0 - at.x - at.y, at.x, at.y};
}

}  // namespace sline::render
