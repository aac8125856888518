// SPDX-License-Identifier: Apache-2.0
// Holds a layer as the processor draws it: the same values that an atlas has on a graphics card
// (METHOD §10).
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <span>
#include <vector>

#include "render/raster/pixel_rect.h"
#include "render/software/seen_cluster.h"

namespace sline::render {

/// Names the samples of a grid from `area`'s corner on: sample (0, 0) has the grid's own corner.
struct SampleArea {
  SampleGrid grid;
  PixelRect area;

  /// Returns the place, in rows from the area's corner, of the sample that stands for a pixel.
  std::size_t at(const glm::ivec2& pixel) const {
    // Multiplies by 2³² / step and a little more, as divisions take long; none of the pixels that
    // are added lets a number be negative.
    constexpr std::array<std::uint64_t, 5> perStep{0, 0x100000001, 0x80000001, 0x55555556,
                                                   0x40000001};
    constexpr int before = 1 << 16;
    const auto step = std::size_t(grid.step);
    const auto sampleOf = [&](int from) {
      return int((std::uint64_t(from + before * grid.step) * perStep[step]) >> 32U) - before;
    };
    const glm::ivec2 from = pixel - grid.corner;
    return std::size_t(sampleOf(from.y) - area.y) * std::size_t(area.width) +
           std::size_t(sampleOf(from.x) - area.x);
  }
};

/// Only the squares that a layer touches hold anything; elsewhere pixels are left as they were.
/// Rows follow each other from the bottom. Without an area there is nothing, but perhaps memory
/// that served another layer, to be used again.
struct LayerPixels {
  PixelRect area;      ///< in pixels of the picture
  SampleArea samples;  ///< of its surface
  bool filled = false;
  std::vector<float> surfaceDepths;           ///< at the samples; 1: nothing is there
  std::vector<std::uint32_t> surfaceColours;  ///< at the samples, where these are not the pixels
  std::vector<std::uint32_t> colours;         ///< red in the lowest 8 bits, premultiplied
  /// Coverage in the lowest 8 bits, and above up to 127 that of hidden lines, or 255 for a halo.
  std::vector<std::uint16_t> inks;
  std::vector<float> depths;  ///< of the layer: 1 where it has nothing

  bool empty() const { return area.empty(); }
  /// Leaves nothing but the memory.
  void clear() { area = {}; }
  /// Tells whether all that is shown of the layer has the area's size.
  bool complete() const {
    const std::size_t count = std::size_t(area.width) * std::size_t(area.height);
    return depths.size() == count && inks.size() == count && (!filled || colours.size() == count);
  }
  int step() const { return samples.grid.step; }
  /// Returns the place of a pixel of the area.
  std::size_t at(int x, int y) const {
    return std::size_t(y - area.y) * std::size_t(area.width) + std::size_t(x - area.x);
  }
  static constexpr std::size_t nowhere = std::size_t(-1);
  /// Returns the sample that stands for a pixel; `nowhere` outside the area.
  std::size_t sampleAt(const glm::vec2& pixel) const {
    // What is not negative needs no rounding down, which takes long.
    const glm::vec2 from = pixel - glm::vec2(float(area.x), float(area.y));
    if (!(from.x >= 0.0f && from.y >= 0.0f && from.x < float(area.width) &&
          from.y < float(area.height)))
      return nowhere;
    return samples.at({area.x + int(from.x), area.y + int(from.y)});
  }
  /// Returns how deep the surface lies at a pixel; 1 outside the area.
  float surfaceDepthAt(const glm::vec2& pixel) const {
    const std::size_t at = sampleAt(pixel);
    return at == nowhere ? 1.0f : surfaceDepths[at];
  }
};

/// Returns a premultiplied colour as pixels hold it.
std::uint32_t packedColour(const glm::vec4& colour);
/// Makes the surface's samples ready: within the rectangles, which are pixels of the area, there is
/// nothing then.
void wipeSurface(LayerPixels& pixels, std::span<const PixelRect> rectangles);
/// Gives all else its size.
void makeRoom(LayerPixels& pixels);
/// Makes all else ready likewise.
void wipe(LayerPixels& pixels, std::span<const PixelRect> rectangles);

/// Takes the fill and depth of a layer's surface over into its pixels. Where samples stand for
/// several pixels, they are enlarged as enlarge.frag.glsl does.
class SurfaceTaker {
 public:
  /// The layer must outlive it, and stay where it is.
  explicit SurfaceTaker(LayerPixels& pixels);
  ~SurfaceTaker();
  /// Takes over what the rectangles hold; different ones may be taken at the same time.
  void take(std::span<const PixelRect> rectangles) const;

 private:
  class Enlarger;
  LayerPixels& m_pixels;
  std::unique_ptr<const Enlarger> m_enlarger;
};

}  // namespace sline::render
