// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "render/raster/image.h"

namespace sline::render {

/// Holds the colours of a whole film, so that nothing flickers between palettes of frames: boxes of
/// a histogram are cut where its colours differ most, until there are enough (after Wu: Efficient
/// statistical computations for optimal color quantization. Graphics Gems II, 1991). The ground,
/// the colour of most pixels of the film, is in it exactly.
class GifPalette {
 public:
  /// One index of 256 stays free: for pixels that are clear, or unchanged.
  static constexpr int mostColours = 255;
  using Rgb = std::array<std::uint8_t, 3>;

  /// Returns the palette of frames from all over the film; transparent pixels do not count.
  static GifPalette of(std::span<const Image> frames);

  const std::vector<Rgb>& colours() const { return m_colours; }
  /// Returns the nearest entry. Between two entries the position x, y decides, in a fixed pattern
  /// of 4 × 4 that rests where the picture does.
  std::uint8_t index(const Rgb& colour, int x, int y);

 private:
  std::uint8_t nearest(const Rgb& colour) const;
  std::vector<Rgb> m_colours;
  std::vector<std::int16_t> m_known;  ///< by 6 bits of each channel; −1: not yet looked up
  std::vector<std::pair<Rgb, std::uint8_t>> m_exact;  ///< in order
};

}  // namespace sline::render
