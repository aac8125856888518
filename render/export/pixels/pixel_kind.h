// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <limits>
#include <memory>

#include "model/base/result.h"
#include "render/export/encoding/row_file.h"

namespace sline::render {

enum class PixelKind { png, tiff, exr, jpeg, webp, jp2 };

/// Describes what files of a kind can hold.
struct PixelTraits {
  bool alpha = true;
  bool grey = true;   ///< can have one channel where there is no colour
  bool ink = false;   ///< can have single bits, or black and white alone
  bool deep = false;  ///< can have 16 bits per channel
  int largestSide = std::numeric_limits<int>::max();  ///< in pixels
  double mostPixels = std::numeric_limits<double>::max();
};
PixelTraits traitsOf(PixelKind kind);

/// Returns a WebP file with 8 bits in colour.
Result<std::unique_ptr<RowFile>> webpRows(const PixelLayout& layout,
                                          const std::filesystem::path& file);

}  // namespace sline::render
