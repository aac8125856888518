// SPDX-License-Identifier: Apache-2.0
// Converts rows of a picture on their way into a file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/export/encoding/row_file.h"
#include "render/picture/picture.h"
#include "render/raster/image.h"

namespace sline::render {

/// Holds sRGB with premultiplied alpha, 16 bits per channel, rows from the top.
struct PixelRows {
  int width = 0;
  int height = 0;
  std::vector<std::uint16_t> rgba;
};

/// Returns the image's rows from `top` on.
PixelRows rowsOf(const Image& image, int top, int count);

/// Puts the piece's averages over squares of `side` × `side` pixels at their place in the rows,
/// which begin `top` averaged rows below the picture's upper edge. With 8 bits in the piece the
/// averages hold 8 + 2 · log2(side) bits, with 16 all that 16 can.
void putAverages(const PicturePiece& piece, int side, int top, PixelRows& rows);

/// Returns the pixels as the layout has them, with rows at whole bytes. Without alpha in the layout
/// they stand on white; in grey they have their luminance. With `pureInk` each pixel is black or
/// white.
std::vector<std::byte> packed(const PixelRows& rows, const PixelLayout& layout,
                              bool pureInk = false);

}  // namespace sline::render
