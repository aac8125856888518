// SPDX-License-Identifier: Apache-2.0
// Mends fills that were enlarged, along their contours, as fill_up.frag.glsl and trim.frag.glsl do:
// there samples of what lies on both sides were mixed, and their border runs from sample to sample.
#pragma once

#include "render/software/layer_pixels.h"
#include "render/strokes/ink.h"

namespace sline::render {

/// Fills the surface up to the strokes, which are contours, in the rows first … end − 1 of the
/// picture; outside of them it makes clear what has nothing behind it, and shows what lies behind.
void drawTrims(LayerPixels& pixels, const InkDraw& draw, int first, int end);

}  // namespace sline::render
