// SPDX-License-Identifier: Apache-2.0
#include "render/picture/picture_canvas.h"

#include <algorithm>
#include <cstdint>
#include <span>

namespace sline::render {

Status PictureCanvas::resize(gpu::TextureSize size, bool withDepth) {
  if (target && target->size() == size && target->hasDepth() == withDepth)
    return Unit{};
  target.reset();
  depth.reset();
  colour = std::make_unique<gpu::Texture>(
      deep ? gpu::TextureFormat::rgba16 : gpu::TextureFormat::rgba8, size, "picture");
  if (withDepth)
    depth = std::make_unique<gpu::Texture>(gpu::TextureFormat::depth32f, size, "picture depth");
  auto made = gpu::Target::create({{colour.get()}, depth.get()}, "picture");
  if (!made)
    return made.error();
  target = std::move(*made);
  return Unit{};
}

void copyRegion(const std::vector<std::byte>& pixels, const PixelRect& region, Image& image) {
  for (int y = 0; y < region.height; ++y) {
    const auto* from =
        reinterpret_cast<const std::uint8_t*>(pixels.data()) + std::size_t(y) * region.width * 4;
    std::uint8_t* to = image.rgba.data() +
                       (std::size_t(image.height - 1 - region.y - y) * image.width + region.x) * 4;
    for (int x = 0; x < region.width; ++x, from += 4, to += 4) {
      const int alpha = from[3];
      for (int i = 0; i < 3; ++i)
        to[i] = alpha == 0 ? std::uint8_t(0)
                           : std::uint8_t(std::min(255, (from[i] * 255 + alpha / 2) / alpha));
      to[3] = std::uint8_t(alpha);
    }
  }
}

Result<PicturePiece> pieceOf(gpu::Device& device, const gpu::Target& target,
                             const PixelRect& region, int height) {
  PicturePiece piece{.left = region.x,
                     .top = height - region.top(),
                     .width = region.width,
                     .height = region.height,
                     .rgba = {}};
  const std::size_t row = std::size_t(region.width) * 4;
  piece.rgba.resize(row * std::size_t(region.height));
  const PixelRect all{0, 0, region.width, region.height};
  if (device.dialect() == gpu::Dialect::desktop330) {
    if (Status s = device.read(target, all, std::span(piece.rgba)); !s)
      return s.error();
  } else {
    std::vector<std::byte> bytes(piece.rgba.size());
    if (Status s = device.read(target, all, bytes); !s)
      return s.error();
    std::transform(bytes.begin(), bytes.end(), piece.rgba.begin(), [](std::byte value) {
      return std::uint16_t(257 * std::to_integer<int>(value));
    });
  }
  for (int y = 0; 2 * y < region.height - 1; ++y)
    std::swap_ranges(piece.rgba.begin() + std::ptrdiff_t(row) * y,
                     piece.rgba.begin() + std::ptrdiff_t(row) * (y + 1),
                     piece.rgba.begin() + std::ptrdiff_t(row) * (region.height - 1 - y));
  return piece;
}

std::pair<PixelRect, PixelRect> halves(const PixelRect& region, int grid) {
  PixelRect first = region;
  PixelRect second = region;
  if (region.width >= region.height) {
    first.width = region.width / 2 / grid * grid;
    second = {first.right(), region.y, region.width - first.width, region.height};
  } else {
    first.height = region.height / 2 / grid * grid;
    second = {region.x, first.top(), region.width, region.height - first.height};
  }
  return {first, second};
}

}  // namespace sline::render
