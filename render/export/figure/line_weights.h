// SPDX-License-Identifier: Apache-2.0
// Measures how wide lines are drawn, and makes those wider that would vanish in print.
#pragma once

#include "render/vectors/vector_drawing.h"

namespace sline::render {

/// Tells whether the lines make a tone, which fades as they get thinner.
bool isTone(const VectorLines& lines);

/// Returns the width than which half of the lines, by their length, are not wider; millimetres,
/// infinite where there are none. A stroke whose width varies counts with its mean.
float usualWidthMm(const VectorLines& lines);

/// Draws all lines at least that wide, except those that make tones.
void raiseLines(VectorDrawing& drawing, float leastMm);

}  // namespace sline::render
