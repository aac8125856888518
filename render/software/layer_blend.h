// SPDX-License-Identifier: Apache-2.0
// Blends layers into a picture on the processor, as the resolve pass does on a graphics card: exact
// for any number of overlapping layers, whatever their order (METHOD §10).
#pragma once

#include <cstdint>
#include <glm/vec4.hpp>
#include <span>

#include "model/base/units.h"
#include "render/raster/tile_mask.h"
#include "render/software/layer_pixels.h"

namespace sline::render {

/// A layer, and what of it counts.
struct BlendLayer {
  const LayerPixels* pixels = nullptr;
  const TileMask* mask = nullptr;  ///< where it shows
  Colour ink;
  bool filled = false;
  bool inked = false;
  bool hiddenInk = false;  ///< has lines that show through what lies before them
  bool haloed = false;     ///< keeps lines behind it away from its outline
};

struct LayerBlend {
  PixelRect region;                    ///< in pixels of the picture
  std::span<const BlendLayer> layers;  ///< where two lie equally deep, the first is in front
  const TileMask& wanted;              ///< the region's squares that are blended; others stay
  glm::vec4 background{0.0f};          ///< premultiplied
};

/// Blends into rows of the region from the bottom: red in the lowest 8 bits, premultiplied.
void blend(const LayerBlend& what, std::span<std::uint32_t> picture);

}  // namespace sline::render
