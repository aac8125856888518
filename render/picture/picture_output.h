// SPDX-License-Identifier: Apache-2.0
// Brings what was painted to where a picture goes.
#pragma once

#include <functional>
#include <memory>
#include <span>

#include "render/picture/layer_painter.h"
#include "render/picture/picture_canvas.h"

namespace sline::render {

/// Draws pictures, and keeps from one what serves the next.
struct Easel {
  std::unique_ptr<LayerPainter> painter;
  PictureCanvas canvas;
  PictureCanvas copy;  ///< of pixels in memory over which a driver draws
};

/// Tells where a picture goes: to an image, to a target, in pieces, or nowhere.
struct Output {
  Image* image = nullptr;
  const PictureTarget* target = nullptr;
  const PicturePieces* pieces = nullptr;
  const std::atomic<bool>* unwanted = nullptr;
  std::span<const Outline> outlines = {};
  bool aside = false;  ///< not one of those that are drawn again and again; it has little room
  int samples = 1;     ///< each way, for each pixel of the target
  bool over = false;   ///< the target keeps what it has, under the outlines
};

/// What was painted last at an easel.
struct Delivery {
  Easel& easel;
  const PictureInput& input;
  const PixelRect& region;
  const Output& output;
  /// Returns the device, which is opened where there is none.
  std::function<Result<gpu::Device*>()> device;
};

/// Brings it to the output; returns false where no more is wanted.
Result<bool> deliver(const Delivery& delivery);

}  // namespace sline::render
