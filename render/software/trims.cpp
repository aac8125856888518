// SPDX-License-Identifier: Apache-2.0
#include "render/software/trims.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "model/base/lanes.h"
#include "render/sight/rules.h"
#include "render/software/channels.h"

namespace sline::render {

namespace {

/// The places between four pairs of parallel lines: low ≤ slope·place ≤ high for each.
struct Slabs {
  Lanes slopeY, low, high;
  Lanes run;  ///< 1 over the slope of x

  void set(std::size_t i, const glm::vec2& slope, float lowest, float highest) {
    slopeY[i] = slope.y;
    low[i] = lowest;
    high[i] = highest;
    run[i] = 1.0f / (std::abs(slope.x) < 1e-6f ? 1e-20f : slope.x);
  }
  /// Narrows first … last to the x of a row that lie between all lines.
  void narrow(float y, glm::vec2& span) const {
    const Lanes from = (low - slopeY * y) * run;
    const Lanes to = (high - slopeY * y) * run;
    const Lanes first = smaller(from, to);
    const Lanes last = larger(from, to);
    span.x = std::max({span.x, first[0], first[1], first[2], first[3]});
    span.y = std::min({span.y, last[0], last[1], last[2], last[3]});
  }
};

/// Outward directions may be anywhere where a contour ends: a strip goes no farther, px.
constexpr float overhang = 1.0f;
constexpr float most = 1e6f;  ///< px, more than any picture has

/// Returns four values that follow each other; zeros from the end on, where others may be at work.
template <class Four, class Value>
Four fourFrom(const std::vector<Value>& values, std::size_t at, std::size_t end) {
  Four four{};
  static_assert(sizeof(four) == laneCount * sizeof(Value));
  if (at + laneCount <= end) {
    std::memcpy(&four, values.data() + at, sizeof(four));
    return four;
  }
  for (std::size_t i = 0; at + i < end; ++i)
    four[i] = std::bit_cast<decltype(four[0] + four[0])>(values[at + i]);
  return four;
}

}  // namespace

/// The strip on both sides of a piece of a contour. Strips of one contour meet at their ends.
struct Trimmer::Strip {
  glm::vec2 a;
  glm::vec2 outward;  ///< across the contour
  glm::vec2 along;    ///< over the length: 0 … 1 from end to end
  Slabs slabs;        ///< that bound it, from `a`
  float depth;        ///< at `a`
  float rise;         ///< of the depth, to the other end
  float lift;         ///< the surface's depth differs from that of its contour by less
  float sheet;        ///< by which the surface may curve towards the eye within the strip
};

/// A pixel of a strip.
struct Trimmer::Spot {
  glm::vec2 on;  ///< the nearest place of the contour
  float depth;   ///< there
  float away;    ///< from there, px, outwards
  std::size_t at;
};

Trimmer::Trimmer(LayerPixels& pixels, const InkDraw& draw)
    : m_pixels(pixels),
      m_draw(draw),
      m_step(float(pixels.step())),
      m_reach(float(pixels.step()) + 0.5f) {}

glm::ivec2 Trimmer::rows(const Stroke& s) const {
  const glm::vec2 ab = s.b - s.a;
  const float length = glm::length(ab);
  if (!(length > 1e-4f && length < most))
    return {0, 0};
  const float around = m_reach * std::abs(ab.x) / length + overhang;
  const float low = std::min(s.a.y, s.b.y) - around;
  const float high = std::max(s.a.y, s.b.y) + around;
  return {int(std::floor(std::clamp(low, -most, most))),
          int(std::ceil(std::clamp(high, -most, most)))};
}

void Trimmer::draw(const Stroke& stroke, int first, int end) const {
  const glm::ivec2 own = rows(stroke);
  const int bottom = std::max(own.x, first);
  const int top = std::min(own.y, end);
  if (bottom >= top)
    return;
  const Strip strip = stripOf(stroke);
  for (int y = bottom; y < top; ++y)
    drawRow(strip, y);
}

Trimmer::Strip Trimmer::stripOf(const Stroke& s) const {
  const glm::vec2 ab = s.b - s.a;
  const float length = glm::length(ab);
  const glm::vec2 along = ab / length;
  const glm::vec2 across(-along.y, along.x);
  const float side = glm::dot(across, s.outwardA + s.outwardB) >= 0.0f ? 1.0f : -1.0f;
  const glm::vec2 fromA = side * glm::vec2(s.outwardA.y, -s.outwardA.x);
  const glm::vec2 fromB = side * glm::vec2(s.outwardB.y, -s.outwardB.x);
  const float middle = 0.5f * (s.depthA + s.depthB);
  Strip strip{.a = s.a,
              .outward = side * across,
              .along = along / length,
              .slabs = {},
              .depth = s.depthA,
              .rise = s.depthB - s.depthA,
              .lift = rule::depthLift(middle, s.tolerance, m_draw.projection),
              .sheet = rule::depthLift(middle, m_draw.sheet, m_draw.projection)};
  strip.slabs.set(0, strip.outward, -m_reach, m_reach);
  strip.slabs.set(1, fromA, 0.0f, most);
  strip.slabs.set(2, fromB, -most, glm::dot(fromB, ab));
  strip.slabs.set(3, along, -overhang, length + overhang);
  return strip;
}

void Trimmer::drawRow(const Strip& strip, int y) const {
  const PixelRect& area = m_pixels.area;
  const float dy = float(y) + 0.5f - strip.a.y;
  glm::vec2 span(float(area.x) + 0.5f - strip.a.x, float(area.right()) - 0.5f - strip.a.x);
  strip.slabs.narrow(dy, span);
  if (!(span.x <= span.y && std::abs(strip.a.x) < most))
    return;
  // Far outside the picture numbers are not exact any more.
  const int left = std::max(int(std::ceil(span.x + strip.a.x - 0.5f)), area.x);
  const int right = std::min(int(std::floor(span.y + strip.a.x - 0.5f)), area.right() - 1);
  const std::size_t begin = m_pixels.at(left, y);
  const std::size_t end = m_pixels.at(area.right(), y);
  for (int x = left; x <= right; x += int(laneCount)) {
    const std::size_t at = begin + std::size_t(x - left);
    const Lanes dx = float(x) + 0.5f - strip.a.x + Lanes{0.0f, 1.0f, 2.0f, 3.0f};
    const Lanes away = dx * strip.outward.x + dy * strip.outward.y;
    const Lanes t = dx * strip.along.x + dy * strip.along.y;
    const Lanes depth = strip.depth + strip.rise * smaller(larger(t, Lanes{}), Lanes{} + 1.0f);
    const Lanes known = fourFrom<Lanes>(m_pixels.depths, at, end);
    // Most is the surface as it should be, and what is nearer hides the contour.
    const LaneMask within = (known > depth + strip.lift) & (away <= 0.0f);
    const LaneMask outside = (fourFrom<WholeLanes>(m_pixels.colours, at, end) != 0) &
                             (away > -0.5f) & (known >= depth - strip.sheet);
    unsigned bits =
        bitsOf(within | outside) & ((1u << std::min(right + 1 - x, int(laneCount))) - 1u);
    for (; bits != 0; bits &= bits - 1) {
      const auto lane = std::size_t(std::countr_zero(bits));
      const glm::vec2 place(strip.a.x + dx[lane], float(y) + 0.5f);
      mend(strip, {place - away[lane] * strip.outward, depth[lane], away[lane], at + lane});
    }
  }
}

void Trimmer::mend(const Strip& strip, const Spot& spot) const {
  if (spot.away <= 0.0f && m_pixels.depths[spot.at] > spot.depth + strip.lift)
    fillUp(strip, spot);
  if (spot.away > -0.5f && m_pixels.colours[spot.at] != 0)
    trim(strip, spot);
}

/// Shows the surface where something farther was mixed with it, or nothing is.
void Trimmer::fillUp(const Strip& strip, const Spot& spot) const {
  for (const float steps : {0.5f, 1.0f, 1.5f, 2.25f}) {
    const glm::vec2 within = spot.on - steps * m_step * strip.outward;
    const float found = m_pixels.surfaceDepthAt(within);
    if (found > spot.depth + strip.lift || found < spot.depth - strip.sheet)
      continue;
    take(within, spot.depth + strip.lift, spot.at);
    return;
  }
}

/// Makes clear what nothing lies behind, and shows what does.
void Trimmer::trim(const Strip& strip, const Spot& spot) const {
  // The middle of a coarse pixel is closer than 0.71 steps to any place in it.
  std::array<float, 2> beyond;
  std::array<glm::vec2, 2> places;
  for (std::size_t i = 0; i < places.size(); ++i) {
    places[i] = spot.on + (0.75f * float(i + 1) * m_step + 0.5f) * strip.outward;
    beyond[i] = m_pixels.surfaceDepthAt(places[i]);
  }
  if (beyond[0] >= 1.0f && beyond[1] >= 1.0f) {
    const float left = 1.0f - std::clamp(spot.away + 0.5f, 0.0f, 1.0f);
    std::uint32_t& word = m_pixels.colours[spot.at];
    word = wordOf(left * channelsOf(word));
    return;
  }
  const std::size_t behind = beyond[0] > spot.depth + strip.lift ? 0 : 1;
  const float found = beyond[behind];
  if (spot.away > 0.0f && m_pixels.depths[spot.at] < found && found < 1.0f &&
      found > spot.depth + strip.lift)
    take(places[behind], found, spot.at);
}

void Trimmer::take(const glm::vec2& place, float depth, std::size_t at) const {
  m_pixels.colours[at] = m_pixels.surfaceColours[m_pixels.sampleAt(place)];
  m_pixels.depths[at] = depth;
}

}  // namespace sline::render
