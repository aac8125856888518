// SPDX-License-Identifier: Apache-2.0
// Follows streamlines of the principal directions over a surface, exactly within each triangle
// (METHOD §8).
#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <vector>

#include "model/geometry/face_neighbours.h"
#include "render/lines/streamlines/principal_field.h"

namespace sline::render {

/// A point of a streamline: its start, where it passes from one triangle to the next, or its end.
struct TracedPoint {
  std::uint32_t triangle = 0;
  glm::dvec2 at{0.0};     ///< see LinearFlow
  glm::dvec3 place{0.0};  ///< patient frame, mm
  double way = 0.0;       ///< mm from the start
};

/// A place where a streamline starts: the triangle's barycentre, if nothing else is said.
struct StreamlineStart {
  std::uint32_t triangle = 0;
  glm::dvec2 at{1.0 / 3.0};  ///< see LinearFlow
};

/// May be used from threads.
class StreamlineTracer {
 public:
  StreamlineTracer(const PrincipalField& field, const model::FaceNeighbours& neighbours);

  /// Returns how far a streamline from the triangle's barycentre goes either way: a third of half
  /// the perimeter of the osculating circle, π/(3·max(|κ1|, |κ2|)), at most the median of all
  /// vertices, mm.
  double length(std::uint32_t triangle) const;

  /// Says whether a line is to go no farther than a place where it enters a triangle.
  using Stops = std::function<bool(std::uint32_t triangle, const glm::dvec3& place)>;
  /// Returns the streamline from there along the triangle's direction, or against it. It
  /// ends after `length` mm, at the surface's border and at an umbilic; it is empty where none
  /// starts.
  std::vector<TracedPoint> trace(const StreamlineStart& start, bool along, double length,
                                 const Stops& stops = nullptr) const;

 private:
  class Walk;

  const PrincipalField& m_field;
  const model::FaceNeighbours& m_neighbours;
  double m_longest;  ///< mm
};

}  // namespace sline::render
