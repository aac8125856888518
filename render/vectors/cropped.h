// SPDX-License-Identifier: Apache-2.0
// Cuts a part out of a drawing. Pens are measured by the height of the page that was drawn, so a
// part of a page of another height is how drawings of different sizes have the same pen.
#pragma once

#include "render/vectors/vector_drawing.h"

namespace sline::render {

/// Returns the part of the drawing that lies in the rectangle, as a drawing of that size. Curves
/// without a point in it are left out; others reach over its edges, where who shows it clips them.
VectorDrawing cropped(VectorDrawing drawing, const glm::vec2& corner, const glm::vec2& sizeMm);

}  // namespace sline::render
