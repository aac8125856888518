// SPDX-License-Identifier: Apache-2.0
// Filters values along a line whose points lie at even distances.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

namespace sline::render {

/// Averages with about a Gaussian's weights of that standard deviation, in points: three box
/// filters one after the other. Open lines keep their ends, closed ones (whose last point is the
/// neighbour of the first) have none.
void blur(std::vector<glm::vec2>& points, float deviation, bool closed);

/// Returns for each value the least within `reach` points, smoothed within the same reach: nowhere
/// more than the value itself, without steps.
std::vector<float> softMinimum(const std::vector<float>& values, int reach, bool closed);

/// Returns the points where an open or closed line turns by more than 60° between its arms, `arm`
/// points long, most within an arm's length.
std::vector<std::size_t> corners(const std::vector<glm::vec2>& points, int arm, bool closed);

}  // namespace sline::render
