// SPDX-License-Identifier: Apache-2.0
// Computes what measures need to know of a picture's pixels. Rows count from the top, as in
// `Image`.
#pragma once

#include <span>
#include <vector>

#include "render/raster/image.h"
#include "render/raster/pixel_rect.h"

namespace sline::render {

/// Holds a number for each pixel of a rectangle, row by row.
struct PixelValues {
  int width = 0;
  int height = 0;
  std::vector<float> values;

  float at(int x, int y) const { return values[std::size_t(y) * std::size_t(width) + x]; }
};

/// Returns the mean absolute difference of two pictures of one size over a rectangle within them:
/// over the three colour channels of every pixel, as display values in [0, 1].
double meanDifference(const Image& a, const Image& b, const PixelRect& area);

/// Returns the relative luminance Y of linear light (Rec. 709 weights, IEC 61966-2-1 transfer): 0
/// black … 1 white. The picture must be opaque.
PixelValues luminance(const Image& image, const PixelRect& area);

/// Returns 1 − grey of display values: 0 white paper … 1 black ink. The picture must be opaque.
PixelValues ink(const Image& image);

/// Returns the opacity, 0 … 1.
PixelValues opacity(const Image& image, const PixelRect& area);

/// Tells which pixels of the rectangle count.
struct PixelMask {
  PixelRect area;
  std::vector<std::uint8_t> inside;  ///< 0 or 1 for each pixel of `area`

  std::size_t count() const;
};

/// Returns the smallest rectangle that holds every pixel that is not white; empty where all are
/// white.
PixelRect inkedArea(const Image& image);
/// Returns the smallest rectangle that holds every pixel that is at least half opaque.
PixelRect coveredArea(const Image& image);
/// Returns the pixels of the rectangle that are at least half opaque.
PixelMask coveredMask(const Image& image, const PixelRect& area);
/// Returns the pixels of the mask that lie at least `pixels` inside it.
PixelMask shrunk(const PixelMask& mask, int pixels);
double mean(const PixelValues& values, const PixelMask& mask);

/// Averages within a mask over a neighbourhood with a box that is applied twice, so that a pixel's
/// weight falls off evenly to the sides. Values outside the mask do not count.
class MaskedBlur {
 public:
  /// Prepares the blur; `radius` is that of the box, in pixels.
  MaskedBlur(const PixelMask& mask, int radius);
  PixelValues operator()(const PixelValues& values) const;

 private:
  void box(std::vector<float>& values) const;

  const PixelMask& m_mask;
  int m_radius;
  std::vector<float> m_weight;
};

}  // namespace sline::render
