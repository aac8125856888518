// SPDX-License-Identifier: Apache-2.0
// Draws layers on the processor (render/software), for drivers that would do the same more slowly.
#pragma once

#include <cstdint>
#include <span>

#include "render/picture/layer_painter.h"
#include "render/software/layer_blend.h"
#include "render/software/occlusion.h"

namespace sline::render {

/// Draws the layer, whose squares and strokes are known, into its pixels. Returns false where a
/// driver draws it better, or must, as it has hatching by pixels or a place behind the
/// eye. Of a layer without a fill the surface's depth is found even for a graphics card, which
/// would have to draw it for nothing else; then `Layer::onProcessor` stays false.
bool drawOnProcessor(const PictureInput& input, const PixelRect& region, Layer& layer);

/// Tells whether a moving picture draws the layer's surface before all else, as it may hide much.
bool hidesMuch(const PictureInput& input, const PixelRect& region, const Layer& layer);
/// Draws that surface, of which nothing is known but the area.
void sampleSurface(const PictureInput& input, const PixelRect& region, Layer& layer);
/// Tells whether the layer would not be seen at all.
bool isHidden(const Layer& layer, const Occlusion& occlusion);

/// Returns the layers that show, as they are blended.
std::vector<BlendLayer> blendLayers(std::span<const Layer> layers, Background background);

}  // namespace sline::render
