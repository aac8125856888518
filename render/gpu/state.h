// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "render/raster/pixel_rect.h"

namespace sline::render::gpu {

enum class DepthTest { off, less, lessEqual, always };
enum class Blend {
  off,
  over,     ///< premultiplied source over the destination
  maximum,  ///< per channel the larger of both
  erase,    ///< the destination but for the source's alpha
};
enum class Cull { none, back };

/// Holds everything that a draw call depends on besides program and geometry; nothing carries over
/// from the call before it.
struct DrawState {
  PixelRect viewport;
  std::optional<PixelRect> scissor;
  DepthTest depth = DepthTest::off;
  bool writeDepth = false;  ///< needs a depth test; `always` writes without testing
  bool writeColour = true;
  Blend blend = Blend::off;
  Cull cull = Cull::none;
};

}  // namespace sline::render::gpu
