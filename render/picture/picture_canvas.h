// SPDX-License-Identifier: Apache-2.0
// Has what regions of a picture are drawn into, and reads their pixels from it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "render/gpu/device.h"
#include "render/gpu/texture.h"
#include "render/picture/picture.h"
#include "render/raster/pixel_rect.h"

namespace sline::render {

/// A colour texture to draw the picture into, with a depth texture where requested; none where the
/// processor draws alone.
struct PictureCanvas {
  std::unique_ptr<gpu::Texture> colour;
  std::unique_ptr<gpu::Texture> depth;
  std::unique_ptr<gpu::Target> target;

  bool deep = false;

  Status resize(gpu::TextureSize size, bool withDepth);
};

/// Converts premultiplied rows from the bottom to straight rows from the top, at the region's
/// place.
void copyRegion(std::span<const std::byte> pixels, const PixelRect& region, Image& image);

/// Returns the region's pixels as a piece of a picture `height` pixels high.
Result<PicturePiece> pieceOf(gpu::Device& device, const gpu::Target& target,
                             const PixelRect& region, int height);

/// Returns it of pixels of 8 bits, RGBA, in rows from the bottom.
PicturePiece pieceOf(std::span<const std::uint32_t> pixels, const PixelRect& region, int height);

/// Puts the region's pixels, `samples` each way for one of the target, in their place there.
void putRegion(std::span<const std::uint32_t> pixels, const PixelRect& region, int samples,
               const PictureTarget& target);
/// Lays what was drawn in an area of the picture, as large as the target, over the target's pixels.
void layOver(std::span<const std::uint32_t> colours, const PixelRect& area,
             std::span<const PixelRect> rectangles, const PictureTarget& target);

/// Splits the region in two, at a multiple of `grid`.
std::pair<PixelRect, PixelRect> halves(const PixelRect& region, int grid);

}  // namespace sline::render
