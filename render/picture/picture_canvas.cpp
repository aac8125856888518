// SPDX-License-Identifier: Apache-2.0
#include "render/picture/picture_canvas.h"

#include <algorithm>
#include <array>
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
  target = TRY(gpu::Target::create({{colour.get()}, depth.get()}, "picture"));
  return Unit{};
}

void copyRegion(std::span<const std::byte> pixels, const PixelRect& region, Image& image) {
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

namespace {

PicturePiece emptyPiece(const PixelRect& region, int height) {
  PicturePiece piece{.left = region.x,
                     .top = height - region.top(),
                     .width = region.width,
                     .height = region.height,
                     .rgba = {}};
  piece.rgba.resize(std::size_t(region.width) * 4 * std::size_t(region.height));
  return piece;
}

void spread(std::span<const std::byte> bytes, PicturePiece& piece) {
  std::transform(bytes.begin(), bytes.end(), piece.rgba.begin(),
                 [](std::byte value) { return std::uint16_t(257 * std::to_integer<int>(value)); });
}

/// Turns rows from the bottom to rows from the top.
void turnOver(PicturePiece& piece) {
  const auto row = std::ptrdiff_t(piece.width) * 4;
  for (int y = 0; 2 * y < piece.height - 1; ++y)
    std::swap_ranges(piece.rgba.begin() + row * y, piece.rgba.begin() + row * (y + 1),
                     piece.rgba.begin() + row * (piece.height - 1 - y));
}

}  // namespace

PicturePiece pieceOf(std::span<const std::uint32_t> pixels, const PixelRect& region, int height) {
  PicturePiece piece = emptyPiece(region, height);
  spread(std::as_bytes(pixels), piece);
  turnOver(piece);
  return piece;
}

Result<PicturePiece> pieceOf(gpu::Device& device, const gpu::Target& target,
                             const PixelRect& region, int height) {
  PicturePiece piece = emptyPiece(region, height);
  const PixelRect all{0, 0, region.width, region.height};
  if (device.dialect() == gpu::Dialect::desktop330) {
    TRY(device.read(target, all, std::span(piece.rgba)));
  } else {
    std::vector<std::byte> bytes(piece.rgba.size());
    TRY(device.read(target, all, bytes));
    spread(bytes, piece);
  }
  turnOver(piece);
  return piece;
}

namespace {

/// Returns the mean of that many pixels each way.
std::uint32_t meanOf(const std::uint32_t* first, std::size_t row, int samples) {
  std::array<unsigned, 4> sums{};
  for (int y = 0; y < samples; ++y)
    for (int x = 0; x < samples; ++x)
      for (std::size_t c = 0; c < sums.size(); ++c)
        sums[c] += first[std::size_t(y) * row + std::size_t(x)] >> (8 * c) & 0xffu;
  const auto count = unsigned(samples * samples);
  std::uint32_t mean = 0;
  for (std::size_t c = 0; c < sums.size(); ++c)
    mean |= (sums[c] + count / 2) / count << (8 * c);
  return mean;
}

/// Lays a colour with premultiplied alpha over another.
std::uint32_t laidOver(std::uint32_t colour, std::uint32_t below) {
  const unsigned left = 255u - (colour >> 24);
  std::uint32_t both = 0;
  for (unsigned c = 0; c < 4; ++c) {
    const unsigned seen = ((below >> (8 * c) & 0xffu) * left + 127u) / 255u;
    both |= std::min((colour >> (8 * c) & 0xffu) + seen, 255u) << (8 * c);
  }
  return both;
}

}  // namespace

void putRegion(std::span<const std::uint32_t> pixels, const PixelRect& region, int samples,
               const PictureTarget& target) {
  const auto row = std::size_t(region.width);
  const auto wide = std::size_t(target.width());
  for (int y = 0; y < region.height / samples; ++y) {
    const std::uint32_t* from = pixels.data() + std::size_t(y * samples) * row;
    std::uint32_t* to = target.pixels().data() + std::size_t(region.y / samples + y) * wide +
                        std::size_t(region.x / samples);
    if (samples == 1)
      std::copy_n(from, row, to);
    else
      for (int x = 0; x < region.width / samples; ++x)
        to[x] = meanOf(from + x * samples, row, samples);
  }
}

void layOver(std::span<const std::uint32_t> colours, const PixelRect& area,
             std::span<const PixelRect> rectangles, const PictureTarget& target) {
  for (const PixelRect& rect : rectangles)
    for (int y = rect.y; y < rect.top(); ++y)
      for (int x = rect.x; x < rect.right(); ++x) {
        const std::uint32_t colour =
            colours[std::size_t(y - area.y) * std::size_t(area.width) + std::size_t(x - area.x)];
        std::uint32_t& pixel =
            target.pixels()[std::size_t(y) * std::size_t(target.width()) + std::size_t(x)];
        pixel = laidOver(colour, pixel);
      }
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
