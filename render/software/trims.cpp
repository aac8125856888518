// SPDX-License-Identifier: Apache-2.0
#include "render/software/trims.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>

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
      const std::uint32_t* colours = m_pixels.colours.data() + m_pixels.at(left, y);
      for (int x = left; x < right; ++x) {
        // Most of the box lies beyond the fill.
        if (colours[x - left] == 0)
          continue;
        const glm::vec2 at = glm::vec2(float(x) + 0.5f, float(y) + 0.5f) - a.at;
        const float toB = (at.x * ac.y - at.y * ac.x) * perArea;
        const float toC = (ab.x * at.y - ab.y * at.x) * perArea;
        const float toA = 1.0f - toB - toC;
        // Of two triangles that share an edge one has the pixels on it.
        if (toA > 0.0f && toB >= 0.0f && toC >= 0.0f)
          trim(toA * a.end + toB * b.end + toC * c.end,
               toA * a.outward + toB * b.outward + toC * c.outward,
               toA * a.away + toB * b.away + toC * c.away, m_pixels.at(x, y));
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
