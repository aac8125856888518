// SPDX-License-Identifier: Apache-2.0
// Planar contours as they come, in any order and plane, sorted into stacks of parallel slices.
#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

namespace sline::model {

/// One closed polygon, millimetres LPS; its last point joins its first.
using Contour = std::vector<glm::dvec3>;

/// The outlines in one plane: what lies within an odd number of them is inside, so that a contour
/// in a contour is a hole. Edges that occur twice (the two sides of a keyhole's channel) are gone.
struct SliceOutline {
  double offset = 0.0;  ///< along the stack's normal, mm
  std::vector<std::array<glm::dvec2, 2>> edges;
  std::size_t points = 0;
};

/// Slices near enough to each other to be one body's, ascending.
struct ContourStack {
  glm::dmat3 axes{1.0};  ///< columns u, v, n; a point is u·x + v·y + n·offset
  std::vector<SliceOutline> slices;
  double spacing = 1.0;  ///< the usual distance of neighbours, mm
};

struct ContourStacks {
  std::vector<ContourStack> stacks;
  std::size_t repeated = 0;    ///< contours given twice
  std::size_t outOfPlane = 0;  ///< contours that lie in another plane than most, or in none
  std::size_t missing = 0;     ///< slices without a contour between two with one
  double widestGap = 0.0;      ///< between two stacks, mm; 0: there is one
};

/// The usual distance between neighbouring planes of these contours; 0 where there are fewer than
/// two planes.
double usualSpacing(std::span<const Contour> contours);

/// Contours lie in the planes most of them agree on. A gap of more than `farthestGap` spacings
/// begins another stack. `spacing` (mm) stands in where one slice alone tells none.
ContourStacks stacksOf(std::span<const Contour> contours, double spacing);

}  // namespace sline::model
