// SPDX-License-Identifier: Apache-2.0
// Mends fills that were enlarged, along their contours, as fill_up.frag.glsl and trim.frag.glsl do:
// there samples of what lies on both sides were mixed, and their border runs from sample to sample.
#pragma once

#include "render/software/layer_pixels.h"
#include "render/strokes/ink.h"

namespace sline::render {

class Trimmer {
 public:
  /// The strokes of the draw are contours.
  Trimmer(LayerPixels& pixels, const InkDraw& draw);

  /// Returns the rows of the picture that one of them changes: from the first to before the second.
  glm::ivec2 rows(const Stroke& stroke) const;
  /// Fills the surface up to the stroke, in the rows first … end − 1 of the picture; outside of it
  /// makes clear what has nothing behind it, and shows what lies behind.
  void draw(const Stroke& stroke, int first, int end) const;

 private:
  struct Strip;
  struct Spot;
  Strip stripOf(const Stroke& stroke) const;
  void drawRow(const Strip& strip, int y) const;
  void mend(const Strip& strip, const Spot& spot) const;
  void fillUp(const Strip& strip, const Spot& spot) const;
  void trim(const Strip& strip, const Spot& spot) const;
  void take(const glm::vec2& place, float depth, std::size_t at) const;

  LayerPixels& m_pixels;
  const InkDraw& m_draw;
  float m_step;
  float m_reach;  ///< px to each side
};

}  // namespace sline::render
