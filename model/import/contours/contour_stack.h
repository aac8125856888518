// SPDX-License-Identifier: Apache-2.0
// Sorts planar contours, which come in any order and plane, into stacks of parallel slices.
#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

namespace sline::model {

/// A contour is one closed polygon in millimetres LPS; its last point joins its first.
using Contour = std::vector<glm::dvec3>;

/// Holds the outlines in one plane. A point is inside where it lies within an odd number of them,
/// so that a contour in a contour is a hole. Edges that occur twice (the two sides of a keyhole's
/// channel) are removed.
struct SliceOutline {
  double offset = 0.0;  ///< along the stack's normal, mm
  std::vector<std::array<glm::dvec2, 2>> edges;
  std::size_t points = 0;
};

/// Holds slices near enough to each other to belong to one body, ascending.
struct ContourStack {
  glm::dmat3 axes{1.0};  ///< columns u, v, n; a point is u·x + v·y + n·offset
  std::vector<SliceOutline> slices;
  double spacing = 1.0;  ///< usual distance between neighbours, mm
};

struct ContourStacks {
  std::vector<ContourStack> stacks;
  std::size_t repeated = 0;    ///< contours given twice
  std::size_t outOfPlane = 0;  ///< contours that lie in another plane than most, or in none
  std::size_t missing = 0;     ///< slices without a contour between two that have one
  double widestGap = 0.0;      ///< between two stacks, mm; 0 where there is one stack
};

/// Returns the usual distance between neighbouring planes of these contours, or 0 where there are
/// fewer than two planes.
double usualSpacing(std::span<const Contour> contours);

/// Sorts the contours that lie in the planes most of them agree on. A gap of more than
/// `farthestGap` spacings begins another stack. `spacing` (mm) stands in where a single slice tells
/// none.
ContourStacks stacksOf(std::span<const Contour> contours, double spacing);

}  // namespace sline::model
