// SPDX-License-Identifier: Apache-2.0
// Draws what was ordered band by band, while the bands before are written.
#pragma once

#include <functional>

#include "model/base/result.h"
#include "render/export/order/export_order.h"
#include "render/export/pixels/pixel_rows.h"

namespace sline::render {

/// Receives the bands from the top down, one at a time, on another thread than the one that draws.
using BandTake = std::function<Status(PixelRows&&)>;

struct PageBands {
  glm::ivec2 size{0, 0};  ///< of the picture, pixels
  int samples = 1;        ///< across a pixel
  bool deep = false;      ///< drawn with 16 bits a channel
  /// The most samples that one band may hold: memory is weighed against parts drawn twice at the
  /// seams.
  int bandSamples = 16'000'000;
};

/// Draws the order's picture, with labels. It makes the OpenGL context that it needs, and stops
/// between pieces with `givenUp(target)` when `progress` asks for it.
Status drawBands(const ExportOrder& order, const PageBands& bands, const BandTake& take,
                 const ExportProgress& progress);

/// Returns how many samples across a pixel are worth their time: at least two where more than 8
/// bits or ink alone are asked for.
int usualSamples(glm::ivec2 size, const ExportOrder& order);

}  // namespace sline::render
