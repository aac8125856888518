// SPDX-License-Identifier: Apache-2.0
// Filters values along a line whose points lie at even distances.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <vector>

namespace sline::render {

/// Filters one line after the other, reusing its memory.
class PolylineFilter {
 public:
  /// Averages with about a Gaussian's weights of that standard deviation, in points: three box
  /// filters one after the other. Open lines keep their ends, closed ones (whose last point is the
  /// neighbour of the first) have none.
  void blur(std::vector<glm::vec2>& points, float deviation, bool closed);

  /// Replaces each value by the least within `reach` points, smoothed within the same reach:
  /// nowhere more than the value itself, without steps.
  void softMinimum(std::vector<float>& values, int reach, bool closed);

  /// Returns the points where an open or closed line turns by more than 60° between its arms, `arm`
  /// points long, most within an arm's length.
  std::vector<std::size_t> corners(const std::vector<glm::vec2>& points, int arm, bool closed);

 private:
  std::vector<glm::vec2> m_line;
  std::vector<glm::vec2> m_next;
  std::vector<float> m_values;
  std::vector<float> m_least;
};

}  // namespace sline::render
