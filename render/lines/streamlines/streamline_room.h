// SPDX-License-Identifier: Apache-2.0
// Knows where streamlines may start on a surface and how much room others have left there.
#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "model/geometry/face_neighbours.h"
#include "render/lines/streamlines/streamline_tracer.h"

namespace sline::render {

/// Distances spread over the surface from triangle to triangle, so that they never reach the other
/// side of a thin wall. Starts are numbered: one lies in the middle of each triangle, and several
/// lie evenly in those whose edges are longer than `fineness` mm.
class StreamlineRoom {
 public:
  StreamlineRoom(const model::Mesh& mesh, const model::FaceNeighbours& neighbours, float fineness);

  std::size_t startCount() const { return m_starts.size(); }
  StreamlineStart start(std::size_t i) const;
  std::uint32_t triangle(std::size_t start) const { return m_starts[start].triangle; }

  /// Returns the distance from the start to the nearest line, mm: exactly where it is less than the
  /// reach that lines were added with, else something larger.
  float at(std::size_t start) const { return m_starts[start].room; }
  /// Returns it for the start of that triangle which lies nearest to the place.
  float near(std::uint32_t triangle, const glm::vec3& place) const;

  void add(std::span<const TracedPoint> line, float reach);
  /// Tells that a start has no more room than this, or all those less than `reach` mm from the
  /// line: one that starts there is not worth drawing.
  void limit(std::size_t start, float room) {
    m_starts[start].room = std::min(m_starts[start].room, room);
  }
  void refuse(std::span<const TracedPoint> line, float reach, float room);

 private:
  struct Start {
    glm::vec3 place{0.0f};
    std::uint32_t triangle = 0;
    float room = 0.0f;
  };
  struct Step {
    std::uint32_t triangle;
    std::uint32_t piece;  ///< of the line, near which the triangle lies
  };
  std::span<Start> startsIn(std::uint32_t triangle);
  /// Calls take(step) for the triangles along the line and for neighbours of those that it takes.
  template <class Take>
  void spread(std::span<const TracedPoint> line, const Take& take);

  const model::FaceNeighbours& m_neighbours;
  std::vector<Start> m_starts;
  std::vector<std::uint32_t> m_first;  ///< of each triangle, and one past the last
  std::vector<Step> m_steps;
};

}  // namespace sline::render
