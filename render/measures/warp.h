// SPDX-License-Identifier: Apache-2.0
// Finds where the surface that a picture shows was in the picture before (METHOD §6.10).
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "model/geometry/bvh.h"
#include "render/drawn/picture_view.h"
#include "render/measures/tone.h"

namespace sline::render {

/// Holds the point of a surface that each pixel's centre shows, in millimetres. Rows count from the
/// top.
struct SeenSurface {
  int width = 0;
  int height = 0;
  std::vector<glm::vec3> points;
  std::vector<std::uint8_t> seen;  ///< 0 where a pixel shows no surface

  std::size_t index(int x, int y) const {
    return std::size_t(y) * std::size_t(width) + std::size_t(x);
  }
};
SeenSurface seenSurface(const model::Bvh& bvh, const PictureView& view);

/// Pairs a pixel of one picture with the place in another that shows the same point.
struct WarpedPixel {
  std::uint32_t pixel = 0;  ///< index in the picture now
  glm::vec2 from{0.0f};     ///< in the picture before: column and row from the top left
                            ///< corner, pixel centres at halves
};
/// Returns all pixels that show a point which both views see. It leaves out those next to an edge
/// of what the view before sees, where its picture mixes surfaces that are unrelated.
std::vector<WarpedPixel> warp(const SeenSurface& now, const SeenSurface& before,
                              const PictureView& viewBefore);

/// Returns the value between pixels by Catmull and Rom's cubic, which keeps edges of strokes
/// sharper than linear interpolation does; the result is held within [0, 1]. The place must lie at
/// least two pixels inside.
float sample(const PixelValues& values, const glm::vec2& place);

}  // namespace sline::render
