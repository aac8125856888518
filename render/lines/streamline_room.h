// SPDX-License-Identifier: Apache-2.0
// Knows how much room streamlines have left on a surface.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "model/geometry/face_neighbours.h"
#include "render/lines/streamline_tracer.h"

namespace sline::render {

/// Distances spread over the surface from triangle to triangle, so that they never reach the other
/// side of a thin wall.
class StreamlineRoom {
 public:
  StreamlineRoom(const model::Mesh& mesh, const model::FaceNeighbours& neighbours);

  /// Returns the distance from the triangle's middle to the nearest line, mm: exactly where it is
  /// less than the reach that lines were added with, else something larger.
  float at(std::uint32_t triangle) const { return m_room[triangle]; }
  /// Tells that this much room is not enough for a line.
  void refuse(std::uint32_t triangle, float below) { m_room[triangle] = below; }
  void add(std::span<const TracedPoint> line, float reach);

 private:
  struct Step {
    std::uint32_t triangle;
    std::uint32_t piece;  ///< of the line, near which the triangle lies
  };
  void take(const Step& step, std::span<const TracedPoint> line, float reach);

  const model::FaceNeighbours& m_neighbours;
  std::vector<glm::vec3> m_middles;
  std::vector<float> m_room;
  std::vector<Step> m_steps;
};

}  // namespace sline::render
