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

  bool whole() const {
    return width >= 0 && height >= 0 &&
           rgba.size() == std::size_t(4) * std::size_t(width) * std::size_t(height);
  }
};

/// Returns the image's rows from `top` on; none where it has not so many.
PixelRows rowsOf(const Image& image, int top, int count);

/// Puts the piece's averages over squares of `side` × `side` pixels at their place in the rows,
/// which begin `top` averaged rows below the picture's upper edge. With 8 bits in the piece the
/// averages hold 8 + 2 · log2(side) bits, with 16 all that 16 can. A piece that is not whole
/// squares, or has no place in the rows, is not put anywhere.
void putAverages(const PicturePiece& piece, int side, int top, PixelRows& rows);

/// Returns the pixels as the layout has them, with rows at whole bytes. Without alpha in the layout
/// they stand on white; in grey they have their luminance. With `pureInk` each pixel is black or
/// white. Rows of another width than the layout's give nothing.
std::vector<std::byte> packed(const PixelRows& rows, const PixelLayout& layout,
                              bool pureInk = false);

}  // namespace sline::render
