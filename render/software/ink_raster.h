// SPDX-License-Identifier: Apache-2.0
// Draws strokes on the processor, as the ink pass and its shaders do on a graphics card.
#pragma once

#include <span>

#include "render/software/layer_pixels.h"
#include "render/strokes/ink.h"

namespace sline::render {

/// Draws one after the other onto a layer whose surface is drawn. Their places in an atlas do not
/// matter.
void drawInk(LayerPixels& pixels, std::span<const InkDraw> draws);

}  // namespace sline::render
