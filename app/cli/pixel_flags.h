// SPDX-License-Identifier: Apache-2.0
// The flags of pictures made of pixels, where they go to print.
#pragma once

#include <optional>
#include <string>

#include "model/base/result.h"
#include "render/export/order/export_order.h"

namespace sline::cli {

/// As typed.
struct PixelFlags {
  std::string sizePx;
  double dpi = 300.0;
  int bits = 8;
  bool grey = false;
  std::string samples = "auto";
};

/// An error is a wrong use, here and below.
Result<render::ExportPixels> understood(const PixelFlags& flags, bool blackAndWhite);
/// The page of so many pixels; nothing where no pixels are said.
Result<std::optional<render::ExportPage>> pageOf(const PixelFlags& flags);

}  // namespace sline::cli
