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
  /// What is left of a stroke here, 1 where none is near, 0 where one runs. Strokes farther than
  /// `reachMm` in space are on another sheet of the surface.
  float room(const glm::vec2& at, const glm::vec3& position, float reachMm) const;

 private:
  std::size_t cell(const glm::vec2& at) const;

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
