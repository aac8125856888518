// SPDX-License-Identifier: Apache-2.0
// Declares the options of pictures made of pixels.
#pragma once

#include "render/export/order/export_option.h"

namespace sline::render {

struct PixelOptions {
  /// Bits per channel in PNG, TIFF and JPEG 2000: 8 or 16; 1 means black and white alone.
  int bits = 8;
  bool grey = false;
  int samples = 0;  ///< across a pixel; 0: as many as its size allows
};
inline constexpr int mostSamples = 4;

extern const ExportOption depthOption;
extern const ExportOption greyOption;
extern const ExportOption samplesOption;

}  // namespace sline::render
