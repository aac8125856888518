// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace sline::render {

/// Holds 8-bit sRGB with straight (not premultiplied) alpha, rows from the top, without padding.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
  bool operator==(const Image&) const = default;
};

/// Averages each square of `side` × `side` pixels to one, colours weighted by their alpha. The
/// image's sides must be multiples of `side`.
Image averaged(const Image& image, int side);

}  // namespace sline::render
