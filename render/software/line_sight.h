// SPDX-License-Identifier: Apache-2.0
// Finds where a stroke's own surface leaves it in sight, as sight.frag.glsl does.
#pragma once

#include <cstdint>

#include "render/software/layer_pixels.h"
#include "render/strokes/ink.h"

namespace sline::render {

/// For a stroke no longer than `mostInkSteps`: bit i tells whether place i of `inkSteps` + 1 is in
/// sight, bit 16 + i whether a contour's surface goes on there outside the pen.
std::uint32_t lineSight(const LayerPixels& pixels, const InkDraw& draw, const Stroke& stroke,
                        int steps);

}  // namespace sline::render
