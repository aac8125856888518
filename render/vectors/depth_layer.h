// SPDX-License-Identifier: Apache-2.0
// Draws a structure as pixels without a GPU: how deep its nearest surface lies and how it is filled
// there. This is what the surface and cap passes draw into a layer; it serves to find what hides
// what.
#pragma once

#include <cstdint>
#include <vector>

#include "render/drawn/section_caps.h"
#include "render/drawn/surface_fill.h"

namespace sline::render {

/// One structure's layer of a picture; y points upwards.
struct DepthLayer {
  PixelRect area;
  std::vector<float> depths;        ///< window depth, 1 where there is nothing; row by row
  std::vector<std::uint8_t> tones;  ///< 0: unfilled, else one more than an index into `colours`
  std::vector<glm::vec4> colours;   ///< premultiplied
  /// The first tone that belongs to cut faces; all tones before it are shades of the surface.
  std::size_t firstCapTone = 0;
  /// Pixels outside what it covers where lines behind it stop (METHOD §11.6).
  float halo = 0.0f;
  /// Pixels outside what it covers where its outline's ink hides lines behind it.
  float ink = 0.0f;

  std::ptrdiff_t index(int x, int y) const {
    if (x < area.x || y < area.y || x >= area.right() || y >= area.top())
      return -1;
    return std::ptrdiff_t(y - area.y) * area.width + (x - area.x);
  }
  /// Returns the depth at a pixel, 1 outside the layer, as the picture's shaders do.
  float depthAt(const glm::vec2& pixel) const {
    const std::ptrdiff_t i = index(int(std::floor(pixel.x)), int(std::floor(pixel.y)));
    return i < 0 ? 1.0f : depths[std::size_t(i)];
  }
  bool filled() const { return !tones.empty(); }
  /// Tells whether some parts of the surface let more through than others.
  bool variesInOpacity() const;
};

/// Holds everything that decides a layer's pixels.
struct LayerInput {
  const PictureView& view;
  Background background = Background::white;
  glm::vec3 keyLight{0.0f};    ///< patient frame, unit; 0: there is none
  double pixelsPerTone = 9.0;  ///< pixels along a structure's side for each of its tones
};

/// Draws the surface and the cut faces into `area`, which may extend beyond the picture.
DepthLayer depthLayer(const DrawnStructure& shown, const LayerInput& input, const PixelRect& area);

/// Returns the mean depth of the layer's pixels, 0 … 1.
float meanDepth(const DepthLayer& layer);

}  // namespace sline::render
