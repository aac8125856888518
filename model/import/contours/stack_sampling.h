// SPDX-License-Identifier: Apache-2.0
// Decides how finely a stack of slices is sampled.
#pragma once

#include <glm/vec2.hpp>

#include "model/import/contours/contour_stack.h"
#include "model/import/contours/slice_shape.h"

namespace sline::model {

struct StackExtent {
  glm::dvec2 low{1e300};
  glm::dvec2 high{-1e300};
  double points = 0.0;
  double length = 0.0;  ///< total of all outlines
  double area = 0.0;    ///< enclosed by all of them, measured along rows
};

StackExtent extentOf(const ContourStack& stack);

/// Describes the grid of the slices, how many samples there are along the normal, and how far
/// apart.
struct StackSampling {
  PlaneGrid plane;
  int layers = 0;
  double low = 0.0;   ///< place of the first layer
  double step = 1.0;  ///< between layers
};

/// Returns the finest sampling that the shape needs, with no more than so many samples.
StackSampling samplingOf(const ContourStack& stack, const StackExtent& extent, double samples);

/// Returns how many samples the shape needs and its number of points justifies.
double samplesFor(const ContourStack& stack);

}  // namespace sline::model
