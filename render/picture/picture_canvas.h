// SPDX-License-Identifier: Apache-2.0
// Has what regions of a picture are drawn into, and reads their pixels from it.
#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "render/gpu/device.h"
#include "render/gpu/texture.h"
#include "render/picture/picture.h"
#include "render/raster/pixel_rect.h"

namespace sline::render {

/// A colour texture to draw the picture into, with a depth texture where requested.
struct PictureCanvas {
  std::unique_ptr<gpu::Texture> colour;
  std::unique_ptr<gpu::Texture> depth;
  std::unique_ptr<gpu::Target> target;

  bool deep = false;

  Status resize(gpu::TextureSize size, bool withDepth);
};

/// Converts premultiplied rows from the bottom to straight rows from the top, at the region's
/// place.
void copyRegion(const std::vector<std::byte>& pixels, const PixelRect& region, Image& image);

/// Returns the region's pixels as a piece of a picture `height` pixels high.
Result<PicturePiece> pieceOf(gpu::Device& device, const gpu::Target& target,
                             const PixelRect& region, int height);

/// Splits the region in two, at a multiple of `grid`.
std::pair<PixelRect, PixelRect> halves(const PixelRect& region, int grid);

}  // namespace sline::render
