// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "model/sculpting/implicit.h"

namespace sline::model {

/// Holds a place on the middle surface of a sheet, and half the sheet's thickness there.
struct LaminaPoint {
  glm::vec3 position;
  float halfThickness;
};

/// A curved plate with rounded rims: a flat muscle, a wall, a wing of bone. Its middle surface
/// passes smoothly (a bicubic spline, of continuous curvature) through rows of points, all rows
/// being of one length.
class Lamina {
 public:
  /// Builds the plate from rows of `columns` points; there are at least two rows and columns.
  Lamina(std::span<const LaminaPoint> points, std::size_t columns);
  Lamina(std::initializer_list<LaminaPoint> points, std::size_t columns)
      : Lamina(std::span<const LaminaPoint>(points.begin(), points.size()), columns) {}
  float distance(const glm::vec3& p) const;
  const Box& bounds() const { return m_bounds; }

 private:
  struct PatchPoint {
    glm::vec4 value;  ///< position and half thickness
    glm::vec4 alongU;
    glm::vec4 alongV;
  };
  struct Sample {
    glm::vec3 position;
    float u;
    float v;
  };
  struct Chunk {
    glm::vec3 centre;
    float reach;
    std::size_t first;
    std::size_t end;
  };
  /// Returns the place at (u, v): u runs along rows (0 … columns − 1), v from row to row.
  PatchPoint at(float u, float v) const;
  glm::vec4 control(int row, int column) const;
  void addSamples();
  Sample nearestSample(const glm::vec3& p) const;

  int m_rows;
  int m_columns;
  std::vector<glm::vec4> m_controls;  ///< with one more row and column on every side
  std::vector<Sample> m_samples;
  std::vector<Chunk> m_chunks;
  Box m_bounds;
};

}  // namespace sline::model
