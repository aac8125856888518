// SPDX-License-Identifier: Apache-2.0
// Draws lines around marked structures on the processor, as outline.frag.glsl does on a graphics
// card.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/raster/outline_look.h"
#include "render/raster/tile_mask.h"
#include "render/software/layer_pixels.h"

namespace sline::render {

/// Holds which marked structure is where in an area, and how deep it lies there, in rows from the
/// bottom.
struct MarkedPixels {
  PixelRect area;                     ///< in pixels of the picture
  std::vector<std::uint8_t> numbers;  ///< 0: none
  std::vector<float> depths;
};

/// A filled layer that may hide marked structures.
struct HidingLayer {
  const LayerPixels* pixels;
  const TileMask* mask;  ///< where it has any, of the region's grid
  int number = 0;        ///< the marked structure's that it is, which does not hide itself; 0: none
};

/// Returns the area in which marks have to be known, for structures in these pixels of the region:
/// whole squares of its grid.
PixelRect markedArea(const PixelRect& structures, const PixelRect& region, const OutlineLook& look);

/// What is to be laid over the picture.
struct OutlineInk {
  std::vector<std::uint32_t> colours;  ///< of the marks' area, premultiplied, packed as pixels are
  std::vector<PixelRect> rectangles;   ///< where there may be any, in pixels of the picture
};

/// Draws the line where the marks' numbers change. It is strong where the structure is seen and
/// weak where the layers hide it.
OutlineInk outlineInk(const MarkedPixels& marks, const PixelRect& region,
                      std::span<const HidingLayer> layers, const OutlineLook& look);

}  // namespace sline::render
