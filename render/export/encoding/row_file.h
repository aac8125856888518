// SPDX-License-Identifier: Apache-2.0
// Describes files of pictures that are written row by row, from the top down.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string_view>

#include "model/base/result.h"
#include "render/export/order/export_order.h"

namespace sline::render {

/// Describes a file's pixels.
struct PixelLayout {
  int width = 0;
  int height = 0;
  int channels = 3;  ///< 1 grey, 2 grey and alpha, 3 colour, 4 colour and alpha
  /// Bits per channel: 1, 8 or 16; 32: floats in linear light with premultiplied alpha. Integers
  /// are sRGB with straight alpha.
  int bits = 8;
  float dpi = 0.0f;  ///< 0: not given
  ExportCredit credit = {};

  bool hasAlpha() const { return channels % 2 == 0; }
  bool isGrey() const { return channels < 3; }
  /// Returns the bytes of a row; rows begin at whole bytes.
  std::size_t rowBytes() const {
    return (std::size_t(width) * std::size_t(channels) * std::size_t(bits) + 7) / 8;
  }
};

class RowFile {
 public:
  virtual ~RowFile() = default;
  /// Adds the next rows, any number of them: tightly packed, in the machine's byte order, single
  /// bits from the highest down with 1 for white.
  virtual Status add(std::span<const std::byte> rows) = 0;
  /// Completes the file; to be called when all rows were added.
  virtual Status finish() = 0;
};

/// Takes a file's bytes as they are made.
using ByteSink = std::function<Status(std::string_view)>;

/// Returns a PNG that `sink` gets: 1, 8 or 16 bits, deflated on all cores.
std::unique_ptr<RowFile> pngRows(const PixelLayout& layout, ByteSink sink);
}  // namespace sline::render
