// SPDX-License-Identifier: Apache-2.0
// Keeps strokes apart. A stroke is never cut off by another but grows thinner the nearer it comes,
// so that nothing pops while the camera moves (after the even spacing of B. Jobard and W. Lefer,
// "Creating Evenly-Spaced Streamlines of Arbitrary Density", 1997, made continuous).
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace sline::render {

class StrokeSpacing {
 public:
  struct Mark {
    glm::vec2 at{0.0f};         ///< λ in the picture
    glm::vec2 direction{0.0f};  ///< unit, along the stroke in the picture
    glm::vec3 position{0.0f};   ///< mm
    float strength = 0.0f;      ///< 0 … 1: how much of a stroke is here
  };

  /// `distance` λ between the middles of strokes; marks lie between `low` and `high`.
  StrokeSpacing(float distance, const glm::vec2& low, const glm::vec2& high);
  void add(const Mark& mark);
  struct Place {
    glm::vec2 at{0.0f};
    glm::vec3 position{0.0f};
    float reachMm = 0.0f;  ///< strokes farther than this in space are on another sheet
  };
  /// What is left of a stroke there, 1 where none is near, 0 where one runs.
  float room(const Place& place) const;

 private:
  struct Cell {
    int column;
    int row;
  };
  Cell cell(const glm::vec2& at) const;
  std::size_t index(const Cell& c) const {
    return std::size_t(c.row) * std::size_t(m_columns) + std::size_t(c.column);
  }

  struct Listed {
    Mark mark;
    std::int32_t next;
  };
  float m_distance;
  glm::vec2 m_low;
  int m_columns = 1;
  int m_rows = 1;
  std::vector<std::int32_t> m_first;  ///< of each cell in `m_marks`; −1 for none
  std::vector<Listed> m_marks;
};

}  // namespace sline::render
