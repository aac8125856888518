// SPDX-License-Identifier: Apache-2.0
// Lays out the marks of each pattern on a cut face.
#pragma once

#include "model/anatomy/cut_pattern.h"
#include "render/lines/patterns/face_pen.h"

namespace sline::render {

/// Where marks stand, in the coordinates of the face's plane.
struct PatternLayout {
  double spacing = 1.0;         ///< mm
  glm::dvec2 fibres{1.0, 0.0};  ///< the fibres' direction projected onto the plane, not a unit
};

void drawPattern(model::CutPattern pattern, const PatternLayout& layout, FacePen& pen);

}  // namespace sline::render
