// SPDX-License-Identifier: Apache-2.0
// Draws what was ordered band by band, while the bands before are written.
#pragma once

#include <functional>

#include "model/base/result.h"
#include "render/export/order/export_order.h"
#include "render/export/pixels/pixel_rows.h"

namespace sline::render {

/// Gets the bands from the top down, one at a time, on another thread than the one that draws.
using BandTake = std::function<Status(PixelRows&&)>;

struct PageBands {
  glm::ivec2 size{0, 0};  ///< of the picture, pixels
  int samples = 1;        ///< across a pixel
  bool deep = false;      ///< drawn with 16 bits a channel
  /// What one band may hold, in samples: memory against what is drawn twice at the seams.
  int bandSamples = 16'000'000;
};

/// Draws the order's picture, with labels. Makes the OpenGL context that it needs. Stops between
/// pieces with `givenUp(target)` when `progress` says so.
Status drawBands(const ExportOrder& order, const PageBands& bands, const BandTake& take,
                 const ExportProgress& progress);

/// How many samples across a pixel are worth their time: at least two where more than 8 bits or ink
/// alone are asked for.
int usualSamples(glm::ivec2 size, const ExportOrder& order);

}  // namespace sline::render
