// SPDX-License-Identifier: Apache-2.0
#include "render/software/trims.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>

#include "model/base/lanes.h"
#include "render/software/channels.h"

namespace sline::render {

namespace {

/// A corner of the strip along a contour: its place, that on the contour, the direction outwards,
/// and how far it is away from the contour.
struct TrimCorner {
  glm::vec2 at;
  glm::vec2 end;
  glm::vec2 outward;
  float away;
};

class Trimmer {
 public:
  explicit Trimmer(LayerPixels& pixels) : m_pixels(pixels), m_step(float(pixels.step())) {}

  void draw(const Stroke& s, int first, int end) const {
    const auto corner = [this](const glm::vec2& at, const glm::vec2& outward, bool outer) {
      const float away = outer ? m_step + 0.5f : -0.5f;
      return TrimCorner{at + away * outward, at, outward, away};
    };
    const TrimCorner a = corner(s.a, s.outwardA, false);
    const TrimCorner b = corner(s.a, s.outwardA, true);
    const TrimCorner c = corner(s.b, s.outwardB, false);
    const TrimCorner d = corner(s.b, s.outwardB, true);
    triangle({a, b, c}, first, end);
    triangle({b, d, c}, first, end);
  }

 private:
  void triangle(const std::array<TrimCorner, 3>& corners, int first, int end) const {
    const auto& [a, b, c] = corners;
    const glm::vec2 ab = b.at - a.at;
    const glm::vec2 ac = c.at - a.at;
    const float area = ab.x * ac.y - ab.y * ac.x;
    if (!(std::abs(area) > 1e-6f))
      return;
    const float perArea = 1.0f / area;
    const PixelRect& rect = m_pixels.area;
    const auto bounded = [](float x) { return int(std::clamp(x, -1e6f, 1e6f)); };
    const glm::vec2 low = glm::floor(glm::min(glm::min(a.at, b.at), c.at));
    const glm::vec2 high = glm::ceil(glm::max(glm::max(a.at, b.at), c.at));
    const int left = std::max(bounded(low.x), rect.x);
    const int right = std::min(bounded(high.x), rect.right());
    if (left >= right)
      return;
    for (int y = std::max(bounded(low.y), first); y < std::min(bounded(high.y), end); ++y) {
      const std::size_t row = m_pixels.at(left, y);
      const float atY = float(y) + 0.5f - a.at.y;
      for (int x = left; x < right; x += int(laneCount)) {
        const Lanes columns = float(x) + Lanes{0.0f, 1.0f, 2.0f, 3.0f};
        const Lanes atX = columns + 0.5f - a.at.x;
        const Lanes toB = (atX * ac.y - atY * ac.x) * perArea;
        const Lanes toC = (ab.x * atY - ab.y * atX) * perArea;
        const Lanes toA = 1.0f - toB - toC;
        // Of two triangles that share an edge one has the pixels on it.
        unsigned inside =
            bitsOf((toA > 0.0f) & (toB >= 0.0f) & (toC >= 0.0f) & (columns < float(right)));
        for (; inside != 0; inside &= inside - 1) {
          const auto lane = std::size_t(std::countr_zero(inside));
          const std::size_t at = row + std::size_t(x - left) + lane;
          // Most of the strip lies beyond the fill.
          if (m_pixels.colours[at] != 0)
            trim(toA[lane] * a.end + toB[lane] * b.end + toC[lane] * c.end,
                 toA[lane] * a.outward + toB[lane] * b.outward + toC[lane] * c.outward,
                 toA[lane] * a.away + toB[lane] * b.away + toC[lane] * c.away, at);
        }
      }
    }
  }

  void trim(const glm::vec2& end, const glm::vec2& outward, float away, std::size_t at) const {
    // The middle of a coarse pixel is closer than 0.71 steps to any place in it.
    for (const float steps : {0.75f, 1.5f})
      if (m_pixels.surfaceDepthAt(end + (steps * m_step + 0.5f) * outward) < 1.0f)
        return;
    const float left = 1.0f - std::clamp(away + 0.5f, 0.0f, 1.0f);
    std::uint32_t& word = m_pixels.colours[at];
    word = wordOf(left * channelsOf(word));
  }

  LayerPixels& m_pixels;
  float m_step;
};

}  // namespace

void drawTrims(LayerPixels& pixels, const InkDraw& draw, int first, int end) {
  const Trimmer trimmer(pixels);
  const float around = 2.0f * float(pixels.step()) + 2.0f;
  for (const Stroke& stroke : draw.strokes)
    if (std::min(stroke.a.y, stroke.b.y) - around < float(end) &&
        std::max(stroke.a.y, stroke.b.y) + around > float(first))
      trimmer.draw(stroke, first, end);
}

}  // namespace sline::render
