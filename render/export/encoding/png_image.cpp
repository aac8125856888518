// SPDX-License-Identifier: Apache-2.0
#include "render/export/encoding/png_image.h"

#include <span>
#include <vector>

#include "render/export/encoding/row_file.h"

namespace sline::render {

namespace {

bool isOpaque(const Image& image) {
  for (std::size_t i = 3; i < image.rgba.size(); i += 4)
    if (image.rgba[i] != 255)
      return false;
  return true;
}

std::vector<std::uint8_t> withoutAlpha(const Image& image) {
  std::vector<std::uint8_t> rgb;
  rgb.reserve(image.rgba.size() / 4 * 3);
  for (std::size_t i = 0; i < image.rgba.size(); i += 4)
    rgb.insert(rgb.end(), {image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]});
  return rgb;
}

}  // namespace

Result<std::string> pngOf(const Image& image, const ExportCredit& credit) {
  const bool opaque = isOpaque(image);
  const PixelLayout layout{
      .width = image.width, .height = image.height, .channels = opaque ? 3 : 4, .credit = credit};
  std::string bytes;
  const std::unique_ptr<RowFile> png = pngRows(layout, [&bytes](std::string_view more) -> Status {
    bytes += more;
    return Unit{};
  });
  const std::vector<std::uint8_t> rgb = opaque ? withoutAlpha(image) : std::vector<std::uint8_t>();
  TRY(png->add(std::as_bytes(std::span(opaque ? rgb : image.rgba))));
  TRY(png->finish());
  return bytes;
}

}  // namespace sline::render
