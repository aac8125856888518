// SPDX-License-Identifier: Apache-2.0
// Draws strokes on the processor, as the ink pass and its shaders do on a graphics card.
#pragma once

#include <functional>
#include <span>

#include "render/software/layer_pixels.h"
#include "render/strokes/ink.h"

namespace sline::render {

/// Makes some rows of a layer's pixels ready, first … end − 1 of the picture.
using ReadyRows = std::function<void(int first, int end)>;

/// Makes all rows of the area ready, band by band, several at the same time.
void forEachBand(const PixelRect& area, const ReadyRows& ready);

/// Draws one after the other onto a layer whose surface is drawn. Their places in an atlas do not
/// matter. Rows are made ready just before they are drawn to, several at the same time, so that
/// they are still near the processor then.
void drawInk(LayerPixels& pixels, std::span<const InkDraw> draws, const ReadyRows& ready);

}  // namespace sline::render
