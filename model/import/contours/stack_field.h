// SPDX-License-Identifier: Apache-2.0
// Turns a stack of slices into one function of space that is negative inside the body.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <vector>

#include "model/import/contours/contour_stack.h"

namespace sline::model {

/// Holds samples of a box in the stack's own axes, x fastest, positive on its border.
struct FieldBox {
  glm::ivec3 size{0};
  glm::dvec3 origin{0.0};  ///< (u, v, n) of sample 0
  glm::dvec3 step{1.0};
  std::vector<float> values;
};

/// Samples the stack as a function. Between slices the signed distances to their outlines are
/// interpolated (S. Raya, J. Udupa, "Shape-based interpolation of multidimensional objects", 1990;
/// G. Herman, J. Zheng, C. Bucholtz, "Shape-based interpolation", 1992), monotonically and with
/// continuous slope (F. Fritsch, J. Butland, 1984), so that irregular distances make no terraces
/// and nothing overshoots. A piece of a slice that overlaps nothing in the next one ends half a
/// spacing beyond its slice, rounded as the piece shrank before, because a contour stands for the
/// slab around it.
///
/// Samples are as fine as the shape needs, but no more than `samples`. `goesOn` is asked between
/// slices; the values are empty where it says no.
FieldBox fieldOf(const ContourStack& stack, double samples, const std::function<bool()>& goesOn);

}  // namespace sline::model
