// SPDX-License-Identifier: Apache-2.0
// Trims fills that were enlarged along their contours, as trim.frag.glsl does.
#pragma once

#include "render/software/layer_pixels.h"
#include "render/strokes/ink.h"

namespace sline::render {

/// Makes clear, in the rows first … end − 1 of the picture, what of the fill lies outside the
/// strokes, which are contours.
void drawTrims(LayerPixels& pixels, const InkDraw& draw, int first, int end);

}  // namespace sline::render
