// SPDX-License-Identifier: Apache-2.0
// Makes pictures of known pixels.
#pragma once

#include <cstdint>

#include "render/raster/image.h"

namespace sline::test {

/// Returns a picture in which `pixel(x, y)` gives {red, green, blue, alpha}.
template <class Pixel>
render::Image painted(int width, int height, const Pixel& pixel) {
  render::Image image{.width = width, .height = height, .rgba = {}};
  image.rgba.reserve(std::size_t(width) * std::size_t(height) * 4);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (const int channel : pixel(x, y))
        image.rgba.push_back(std::uint8_t(channel));
  return image;
}

}  // namespace sline::test
