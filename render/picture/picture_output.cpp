// SPDX-License-Identifier: Apache-2.0
#include "render/picture/picture_output.h"

namespace sline::render {

namespace {

PixelRect wholeOf(const PixelRect& region) {
  return {0, 0, region.width, region.height};
}

Status readImage(const Delivery& delivery, Image& image) {
  const PixelRect& region = delivery.region;
  const std::span<const std::uint32_t> blended = delivery.easel.painter->blended();
  if (!blended.empty()) {
    copyRegion(std::as_bytes(blended), region, image);
    return Unit{};
  }
  gpu::Device* const device = TRY(delivery.device());
  std::vector<std::byte> pixels(std::size_t(region.width) * region.height * 4);
  TRY(device->read(*delivery.easel.canvas.target, wholeOf(region), pixels));
  copyRegion(pixels, region, image);
  return Unit{};
}

Result<PicturePiece> readPiece(const Delivery& delivery) {
  const int height = int(delivery.input.view.size().y);
  const std::span<const std::uint32_t> blended = delivery.easel.painter->blended();
  if (!blended.empty())
    return pieceOf(blended, delivery.region, height);
  gpu::Device* const device = TRY(delivery.device());
  return pieceOf(*device, *delivery.easel.canvas.target, delivery.region, height);
}

Status toTexture(const Delivery& delivery, const gpu::Target& texture) {
  gpu::Device* const device = TRY(delivery.device());
  const PixelRect& region = delivery.region;
  const int n = delivery.output.samples;
  if (!delivery.output.over)
    device->copyColour(*delivery.easel.canvas.target, wholeOf(region), texture,
                       {region.x / n, region.y / n, region.width / n, region.height / n});
  for (const Outline& outline : delivery.output.outlines)
    TRY(delivery.easel.painter->outline(*device, delivery.input, {region, texture}, outline));
  return Unit{};
}

/// Draws the line over the target's pixels.
Status outlineInMemory(const Delivery& delivery, const PictureTarget& target,
                       const Outline& outline) {
  LayerPainter& painter = *delivery.easel.painter;
  if (const auto drawn = painter.outline(delivery.input, delivery.region, outline)) {
    layOver(drawn->ink->colours, drawn->area, drawn->ink->rectangles, target);
    return Unit{};
  }
  gpu::Device* const device = TRY(delivery.device());
  PictureCanvas& copy = delivery.easel.copy;
  const PixelRect all{0, 0, target.width(), target.height()};
  TRY(copy.resize({all.width, all.height}, false));
  TRY(copy.colour->upload(std::as_bytes(target.pixels()), all));
  const LayerPainter::OutlinePlace place{delivery.region, *copy.target};
  TRY(painter.outline(*device, delivery.input, place, outline));
  return device->read(*copy.target, all, std::as_writable_bytes(target.pixels()));
}

Status toMemory(const Delivery& delivery, const PictureTarget& target) {
  const PixelRect& region = delivery.region;
  const std::span<const std::uint32_t> blended = delivery.easel.painter->blended();
  if (!delivery.output.over && !blended.empty()) {
    putRegion(blended, region, delivery.output.samples, target);
  } else if (!delivery.output.over) {
    gpu::Device* const device = TRY(delivery.device());
    std::vector<std::uint32_t> pixels(std::size_t(region.width) * std::size_t(region.height));
    const std::span<std::uint32_t> all = pixels;
    TRY(device->read(*delivery.easel.canvas.target, wholeOf(region), std::as_writable_bytes(all)));
    putRegion(pixels, region, delivery.output.samples, target);
  }
  for (const Outline& outline : delivery.output.outlines)
    TRY(outlineInMemory(delivery, target, outline));
  return Unit{};
}

}  // namespace

Result<bool> deliver(const Delivery& delivery) {
  const Output& output = delivery.output;
  if (output.target) {
    const gpu::Target* texture = output.target->texture();
    TRY(texture ? toTexture(delivery, *texture) : toMemory(delivery, *output.target));
  }
  if (output.image)
    TRY(readImage(delivery, *output.image));
  if (!output.pieces)
    return true;
  PicturePiece piece = TRY(readPiece(delivery));
  return output.pieces->take(std::move(piece));
}

}  // namespace sline::render
