// SPDX-License-Identifier: Apache-2.0
// Fields of TIFF 6.0 and the directory that lists them, in little-endian order: those of a TIFF
// file and of a JPEG's Exif block.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "render/export/pixels/row_file.h"

namespace sline::render {

enum class TiffType : std::uint16_t {
  octets = 1,
  ascii = 2,
  shorts = 3,
  longs = 4,
  rational = 5,
  bytes = 7,
  long8 = 16
};

struct TiffField {
  std::uint16_t tag;
  TiffType type;
  std::uint64_t count;
  std::string data;
};

TiffField shortField(std::uint16_t tag, const std::vector<unsigned>& values);
TiffField longField(std::uint16_t tag, std::uint64_t value);
TiffField textField(std::uint16_t tag, const std::string& text);

/// Resolution, program, author and terms of use, as far as the layout says them. In no order.
std::vector<TiffField> descriptiveFields(const PixelLayout& layout);

struct TiffDirectory {
  std::string bytes;
  std::uint64_t at = 0;  ///< where in the file the directory itself begins
};

/// The fields, in the order of their tags, for bytes that are to stand at `start`. `big`: as in
/// BigTIFF.
TiffDirectory tiffDirectory(std::vector<TiffField> fields, std::uint64_t start, bool big);

}  // namespace sline::render
