// SPDX-License-Identifier: Apache-2.0
#include "render/export/pixels/pixel_weight.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>
#include <system_error>

#include "model/disk/temporary_folder.h"
#include "render/export/pixels/image_file.h"
#include "render/export/pixels/pixel_files.h"
#include "render/export/pixels/pixel_rows.h"

namespace sline::render {

namespace {

/// Returns the image half as wide and high; an odd last row or column is left out.
Image halved(const Image& image) {
  Image even{.width = image.width / 2 * 2, .height = image.height / 2 * 2, .rgba = {}};
  const std::size_t row = std::size_t(4) * std::size_t(even.width);
  for (int y = 0; y < even.height; ++y) {
    const auto from = image.rgba.begin() + std::ptrdiff_t(4) * image.width * y;
    even.rgba.insert(even.rgba.end(), from, from + std::ptrdiff_t(row));
  }
  return averaged(even, 2);
}

/// Puts noise into what 8 bits do not tell of tones that change from pixel to pixel: such tones
/// have no pattern there that an encoder could find.
void addDepth(PixelRows& rows) {
  std::minstd_rand random(1);
  std::uniform_int_distribution<int> low(0, 255);
  for (std::size_t i = rows.rgba.size() / 4; i-- > 1;) {
    std::uint16_t* const pixel = &rows.rgba[4 * i];
    if (std::equal(pixel, pixel + 3, pixel - 4))
      continue;
    for (int c = 0; c < 3; ++c)
      pixel[c] = std::uint16_t((pixel[c] & 0xff00) | low(random));
  }
}

/// Returns the size of the file that holds the image alone; 0 where there is none.
double encodedBytes(const ExportOrder& order, PixelKind kind, const Image& image) {
  const Result<model::TemporaryFolder> folder = model::TemporaryFolder::create();
  if (!folder.ok())
    return 0.0;
  const PixelLayout layout = layoutOf(order, kind, {image.width, image.height});
  const std::filesystem::path target = folder->path() / "picture";
  {
    const Result<std::unique_ptr<RowFile>> file = rowFile(kind, layout, target);
    if (!file.ok())
      return 0.0;
    PixelRows rows = rowsOf(image, 0, image.height);
    if (layout.bits == 16)
      addDepth(rows);
    if (!(*file)->add(packed(rows, layout, isInkAlone(order, kind))).ok() ||
        !(*file)->finish().ok())
      return 0.0;
  }
  std::error_code fault;
  const std::uintmax_t bytes = std::filesystem::file_size(target, fault);
  return fault ? 0.0 : double(bytes);
}

}  // namespace

double pixelWeight(const ExportOrder& order, PixelKind kind, const Image& page) {
  constexpr int least = 32;  // pixels of a side that says anything
  if (std::min(page.width, page.height) < least)
    return 0.0;
  const double whole = encodedBytes(order, kind, page);
  const double half = encodedBytes(order, kind, halved(page));
  if (whole <= 0.0 || half <= 0.0)
    return 0.0;
  // Edges cost bytes by their length, areas by their pixels: anything between is possible.
  const double power = std::clamp(std::log(whole / half) / std::log(4.0), 0.5, 1.0);
  const glm::dvec2 size(pixelsOf(order.page));
  const double times = size.x * size.y / (double(page.width) * double(page.height));
  return whole * std::pow(times, power);
}

}  // namespace sline::render
