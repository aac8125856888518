// SPDX-License-Identifier: Apache-2.0
// Knows which places on a surface strokes have taken (after B. Jobard and W. Lefer, "Creating
// Evenly-Spaced Streamlines of Arbitrary Density", 1997).
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "model/geometry/mesh.h"

namespace sline::render {

class StrokeSpacing {
 public:
  struct Mark {
    glm::vec3 position{0.0f};  ///< mm
    glm::vec3 normal{0.0f};    ///< unit; keeps the two sheets of a thin wall apart
  };

  /// Keeps strokes `distance` mm apart; marks outside the box are ignored.
  StrokeSpacing(float distance, const model::Box& box);
  void add(const Mark& mark);
  /// Adds marks at the ends of so many equal pieces of the way from there to the mark. Those
  /// outside the box take no time: where it is small, there may be millions.
  void addAlong(const glm::vec3& from, const Mark& to, int pieces);
  /// Returns the distance to the nearest mark as a share of that between strokes, at most 1.
  float room(const Mark& place) const;

 private:
  struct Cell {
    int x, y, z;
  };
  Cell cell(const glm::vec3& p) const;
  std::size_t index(const Cell& c) const {
    return (std::size_t(c.z) * std::size_t(m_size.y) + std::size_t(c.y)) * std::size_t(m_size.x) +
           std::size_t(c.x);
  }

  struct Listed {
    Mark mark;
    std::int32_t next;
  };
  float m_distance;
  model::Box m_box;
  Cell m_size;
  std::vector<std::int32_t> m_first;  ///< of each cell, an index into `m_marks`; −1 for none
  std::vector<Listed> m_marks;
};

}  // namespace sline::render
