// SPDX-License-Identifier: Apache-2.0
// Draws tones that let something through as pixels, smooth and blended as the picture does. Shapes
// of one tone each would need too many steps where a dozen of them lie one over the other.
#pragma once

#include <span>
#include <vector>

#include "render/raster/image.h"
#include "render/vectors/seen_tones.h"

namespace sline::render {

/// Holds one layer's tones.
struct ToneImage {
  PixelRect area;  ///< of the picture, y upwards
  Image image;     ///< of fewer pixels than the area; empty where shapes draw the tones
};

/// Returns one image for each layer; only those have pixels whose surface lets more through in some
/// parts than in others. `seen` and `ranks` are those of the layers.
///
/// The picture blends fills by their depth at each pixel, but a page has one order for all of it.
/// An image's alpha is therefore not that of the fill: it is chosen at each pixel so that each fill
/// has the picture's share of light when all are painted by rank. Colours stay what they are.
std::vector<ToneImage> toneImages(const LayerStack& stack, std::span<const DepthLayer> layers,
                                  std::span<const SeenTones> seen,
                                  std::span<const std::size_t> ranks);

}  // namespace sline::render
