// SPDX-License-Identifier: Apache-2.0
// Computes the solvent-accessible surface: where the centre of a probe rolls that touches atoms
// without entering any. It is the boundary of a union of balls, each an atom grown by the probe's
// radius (Lee & Richards, J. Mol. Biol. 55, 1971): patches of spheres, arcs where two meet, corners
// where three do.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace sline::model {

/// Describes a ball of the union; positions and radii are in ångström.
struct Ball {
  glm::dvec3 centre;
  double radius = 0.0;
};

/// Describes the part of the circle on which two balls' spheres meet that no third ball covers.
struct ExposedArc {
  std::uint32_t other = 0;  ///< the second of the two balls
  glm::dvec3 centre;
  glm::dvec3 u;  ///< unit, in the circle's plane: angle 0
  glm::dvec3 v;  ///< unit, angle π/2
  double radius = 0.0;
  std::vector<std::pair<double, double>> spans;  ///< in [0, 2π]; one for a whole circle

  bool holds(double angle) const;
  bool isWhole() const;
};

class SolventAccessible {
 public:
  /// Returns the surface, or nothing where the balls lie more densely than matter does (so that
  /// working it out would take unbounded time) or `goesOn` says no. Balls inside others are left
  /// out.
  static std::optional<SolventAccessible> of(std::vector<Ball> balls,
                                             const std::function<bool()>& goesOn);

  const std::vector<Ball>& balls() const { return m_balls; }
  bool isExposed(std::size_t ball) const { return m_exposed[ball] != 0; }
  /// Returns the arcs on the sphere of this ball that it shares with balls of higher index.
  std::span<const ExposedArc> arcsOf(std::size_t ball) const;
  /// Returns the balls that overlap this one, the nearest first.
  std::span<const std::uint32_t> neighboursOf(std::size_t ball) const;
  /// Tells whether a point on the sphere of `ball` lies in no other ball.
  bool isFree(const glm::dvec3& p, std::size_t ball) const;
  /// Returns all balls that come nearer to the box than `reach`.
  std::vector<std::uint32_t> ballsNear(const glm::dvec3& low, const glm::dvec3& high,
                                       double reach) const;
  double largestRadius() const { return m_largest; }
  /// Returns the area in Å², from 48 points on each exposed sphere (Shrake & Rupley, J. Mol. Biol.
  /// 79, 1973).
  double roughArea() const;

 private:
  using Cell = std::array<std::int64_t, 3>;

  SolventAccessible() = default;
  Cell cellOf(const glm::dvec3& p) const;
  bool sortIntoCells();
  bool findNeighbours(const std::function<bool()>& goesOn);
  void leaveOutSwallowed();
  void findArcs(std::size_t ball);
  std::optional<ExposedArc> arcOf(std::size_t a, std::size_t b) const;

  std::vector<Ball> m_balls;
  double m_largest = 0.0;
  std::vector<std::pair<Cell, std::uint32_t>> m_cells;  ///< sorted: (cell, ball)
  std::vector<std::uint32_t> m_neighbours;
  std::vector<std::size_t> m_neighbourStart;
  std::vector<std::vector<ExposedArc>> m_arcs;
  std::vector<char> m_exposed;
};

}  // namespace sline::model
