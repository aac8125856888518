// SPDX-License-Identifier: Apache-2.0
#include "render/software/ink_raster.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "model/base/parallel.h"
#include "render/raster/rounding.h"
#include "render/software/line_sight.h"
#include "render/software/paper.h"
#include "render/software/trims.h"
#include "render/strokes/fill_shading.h"
#include "render/strokes/window_depth.h"

namespace sline::render {

namespace {

/// The stored value of hidden ink that covers all; a halo is more (resolve.frag.glsl).
constexpr float hiddenCoverage = 0.5f;

/// A piece of a stroke as it is drawn: a capsule, and what of it is in sight. See capsule.glsl.
struct Capsule {
  glm::vec2 a;  ///< where the stroke's own middle runs
  glm::vec2 along;
  glm::vec2 perAlong;  ///< 1 over each
  float length;
  float reach;  ///< across
  glm::vec2 beyond;
  float depthA, depthB;
  float halfWidthA, halfWidthB;
  float opacityA, opacityB;
  float edge;   ///< pixels over which it fades
  float inner;  ///< share that remains within the surface's own mask
  float lift;   ///< by which a contour lies in front
  int steps;
  std::uint32_t sight;
  glm::vec2 outwardA, outwardB;
  glm::vec2 penA, penB;  ///< where the pen draws the line itself
  int bottom, top;       ///< rows of the picture, the last one not included
};

float reachOf(const Stroke& s) {
  return std::max(s.halfWidthA, s.halfWidthB) + 0.5f;
}

Capsule capsuleOf(const InkDraw& draw, const Stroke& s, std::uint32_t sight) {
  Capsule c{};
  c.penA = s.a + s.moveA;
  c.penB = s.b + s.moveB;
  c.a = c.penA + s.outwardA * std::max(s.halfWidthA - 0.5f, 0.0f);
  const glm::vec2 b = c.penB + s.outwardB * std::max(s.halfWidthB - 0.5f, 0.0f);
  c.length = glm::distance(c.a, b);
  c.along = c.length > 1e-6f ? (b - c.a) / c.length : glm::vec2(1.0f, 0.0f);
  c.perAlong = 1.0f / c.along;
  c.reach = reachOf(s);
  c.beyond = glm::min(glm::vec2(s.capA, s.capB), glm::vec2(c.reach));
  c.depthA = s.depthA, c.depthB = s.depthB;
  c.halfWidthA = s.halfWidthA, c.halfWidthB = s.halfWidthB;
  c.opacityA = s.opacityA, c.opacityB = s.opacityB;
  c.edge = s.kind == StrokeKind::hatching ? s.softness : 1.0f;
  c.inner = s.kind == StrokeKind::contour ? s.innerShare : 1.0f;
  c.lift = draw.kind == InkKind::contours
               ? depthLift(0.5f * (s.depthA + s.depthB), 2.0f * s.tolerance, draw.projection)
               : 0.0f;
  c.steps = inkSteps(s);
  c.sight = sight;
  c.outwardA = s.outwardA, c.outwardB = s.outwardB;
  const float rise = std::abs(c.along.y);
  const float side = std::abs(c.along.x) * c.reach;
  const float low = std::min(c.a.y - (c.along.y > 0.0f ? c.beyond.x : -c.beyond.x) * rise,
                             b.y + (c.along.y > 0.0f ? c.beyond.y : -c.beyond.y) * rise);
  const float high = std::max(c.a.y - (c.along.y > 0.0f ? c.beyond.x : -c.beyond.x) * rise,
                              b.y + (c.along.y > 0.0f ? c.beyond.y : -c.beyond.y) * rise);
  const float limit = 1e6f;
  c.bottom = int(std::floor(std::clamp(low - side, -limit, limit)));
  c.top = int(std::ceil(std::clamp(high + side, -limit, limit)));
  return c;
}

/// A slope, and what goes once over it.
struct Slope {
  float rise;
  float run;
};

/// Narrows first … last to the x at which low ≤ slope·x + constant ≤ high.
void narrow(const Slope& slope, float constant, float low, float high, glm::vec2& span) {
  if (std::abs(slope.rise) < 1e-6f) {
    if (constant < low || constant > high)
      span = {1.0f, 0.0f};
    return;
  }
  const float from = (low - constant) * slope.run;
  const float to = (high - constant) * slope.run;
  span = {std::max(span.x, std::min(from, to)), std::min(span.y, std::max(from, to))};
}

/// A pixel of a capsule.
struct Spot {
  glm::vec2 pixel;
  float t;         ///< along the capsule, 0 … 1
  float distance;  ///< from the stroke's middle, px
  std::size_t at;  ///< in the layer
};

float mixed(float a, float b, float t) {
  return a + t * (b - a);
}

/// Returns the analytic coverage (METHOD §4).
float coverageOf(float halfWidth, float distance, float edge) {
  return std::clamp((halfWidth - distance) / edge + 0.5f, 0.0f, 1.0f);
}

std::uint16_t byteOf(float value) {
  return std::uint16_t(nearestWhole(255.0f * std::clamp(value, 0.0f, 1.0f)));
}

/// Draws capsules of one kind, row by row.
class CapsuleDrawer {
 public:
  CapsuleDrawer(LayerPixels& pixels, const InkDraw& draw) : m_pixels(pixels), m_draw(draw) {}

  /// Draws those rows of the capsule that lie in first … end − 1.
  void draw(const Capsule& c, int first, int end) const {
    switch (m_draw.kind) {
      case InkKind::surfaceLines:
        forEachSpot(c, first, end, [&](const Spot& spot) { surfaceLine(c, spot); });
        break;
      case InkKind::contours:
      case InkKind::hidden:
        forEachSpot(c, first, end, [&](const Spot& spot) { contour(c, spot); });
        break;
      case InkKind::halos:
        forEachSpot(c, first, end, [&](const Spot& spot) { halo(c, spot); });
        break;
      case InkKind::edges:
        forEachSpot(c, first, end, [&](const Spot& spot) { edge(c, spot); });
        break;
      case InkKind::trims:
        break;
    }
  }

 private:
  template <class Body>
  void forEachSpot(const Capsule& c, int first, int end, const Body& body) const {
    const PixelRect& area = m_pixels.area;
    for (int y = std::max(c.bottom, first); y < std::min(c.top, end); ++y) {
      const float dy = float(y) + 0.5f - c.a.y;
      glm::vec2 span(float(area.x) + 0.5f - c.a.x, float(area.right()) - 0.5f - c.a.x);
      narrow({c.along.x, c.perAlong.x}, dy * c.along.y, -c.beyond.x, c.length + c.beyond.y, span);
      narrow({-c.along.y, -c.perAlong.y}, dy * c.along.x, -c.reach, c.reach, span);
      if (span.x > span.y)
        continue;
      const int left = int(std::ceil(span.x + c.a.x - 0.5f));
      const int right = int(std::floor(span.y + c.a.x - 0.5f));
      const float perLength = c.length > 1e-6f ? 1.0f / c.length : 0.0f;
      for (int x = left; x <= right; ++x) {
        const float dx = float(x) + 0.5f - c.a.x;
        const float way = dx * c.along.x + dy * c.along.y;
        const float across = dy * c.along.x - dx * c.along.y;
        const float outside = way - std::clamp(way, 0.0f, c.length);
        const float t = std::clamp(way * perLength, 0.0f, 1.0f);
        const float distance =
            outside == 0.0f ? std::abs(across) : std::sqrt(across * across + outside * outside);
        if (!(distance < mixed(c.halfWidthA, c.halfWidthB, t) + 0.5f))
          continue;
        body(Spot{{float(x) + 0.5f, float(y) + 0.5f}, t, distance, m_pixels.at(x, y)});
      }
    }
  }

  /// Returns the bits of the place that is nearest to the spot's.
  static std::uint32_t sightAt(const Capsule& c, const Spot& spot) {
    return c.sight >> nearestWhole(spot.t * float(c.steps));
  }
  static glm::vec2 outwardAt(const Capsule& c, float t) {
    return glm::normalize(glm::mix(c.outwardA, c.outwardB, t) + glm::vec2(1e-6f, 0.0f));
  }
  float grained(float coverage, const glm::vec2& pixel) const {
    return m_draw.grain > 0.0f ? coverage * paperAt(pixel, {m_draw.grain, m_draw.grainSize})
                               : coverage;
  }

  void surfaceLine(const Capsule& c, const Spot& spot) const {
    if ((sightAt(c, spot) & 1u) == 0)
      return;
    const float halfWidth = mixed(c.halfWidthA, c.halfWidthB, spot.t);
    const float coverage = grained(
        coverageOf(halfWidth, spot.distance, c.edge) * mixed(c.opacityA, c.opacityB, spot.t),
        spot.pixel);
    if (coverage > least)
      put(spot.at, byteOf(coverage), mixed(c.depthA, c.depthB, spot.t));
  }

  void contour(const Capsule& c, const Spot& spot) const {
    const std::uint32_t sight = sightAt(c, spot);
    if ((sight & 1u) == 0)
      return;
    float halfWidth = mixed(c.halfWidthA, c.halfWidthB, spot.t);
    float opacity = mixed(c.opacityA, c.opacityB, spot.t);
    float distance = spot.distance;
    if (c.inner < 1.0f) {
      const glm::vec2 place = glm::mix(c.penA, c.penB, spot.t);
      if ((sight & 0x10000u) != 0 || (m_pixels.surfaceDepthAt(spot.pixel) < 1.0f &&
                                      glm::distance(spot.pixel, place) > float(m_pixels.step()))) {
        // Thinner strokes keep one pixel and lose opacity instead.
        const float thin = halfWidth * c.inner;
        opacity *= std::min(1.0f, thin * 2.0f);
        halfWidth = std::max(thin, 0.5f);
        distance = glm::distance(spot.pixel, place + outwardAt(c, spot.t) * (halfWidth - 0.5f));
      }
    }
    const float coverage = grained(coverageOf(halfWidth, distance, 1.0f) * opacity, spot.pixel);
    if (!(coverage > least))
      return;
    if (m_draw.kind == InkKind::hidden) {
      raise(spot.at, std::uint16_t(byteOf(hiddenCoverage * coverage) << 8));
      return;
    }
    const float depth = mixed(c.depthA, c.depthB, spot.t);
    put(spot.at, byteOf(coverage), std::clamp(depth - c.lift, 0.0f, depth));
  }

  void halo(const Capsule& c, const Spot& spot) const {
    if (spot.distance >= mixed(c.halfWidthA, c.halfWidthB, spot.t) ||
        (sightAt(c, spot) & 1u) == 0 || m_pixels.surfaceDepthAt(spot.pixel) < 1.0f)
      return;
    put(spot.at, 0xff00, mixed(c.depthA, c.depthB, spot.t));
  }

  void edge(const Capsule& c, const Spot& spot) const {
    if ((sightAt(c, spot) & 1u) == 0)
      return;
    const float depth = mixed(c.depthA, c.depthB, spot.t);
    float coverage = coverageOf(mixed(c.halfWidthA, c.halfWidthB, spot.t), spot.distance, 1.0f) *
                     mixed(c.opacityA, c.opacityB, spot.t);
    // The pixels that the surface covers are whole; only the fringe outside remains.
    if (coverage <= least || m_pixels.surfaceDepthAt(spot.pixel) <= depth)
      return;
    coverage *= m_draw.paint.a;
    const glm::vec3 shaded =
        glm::min(edgeColour(glm::vec3(m_draw.paint), m_draw.key, outwardAt(c, spot.t)), 1.0f);
    std::uint32_t& word = m_pixels.colours[spot.at];
    std::uint32_t over = 0;
    for (int channel = 0; channel < 4; ++channel) {
      const float source = channel < 3 ? shaded[channel] * coverage : coverage;
      const float below = float((word >> (8 * channel)) & 255u);
      over |= std::uint32_t(std::min(255.0f * source + below * (1.0f - coverage) + 0.5f, 255.0f))
              << (8 * channel);
    }
    word = over;
    m_pixels.depths[spot.at] = std::clamp(depth, 0.0f, 1.0f);
  }

  /// Joins ink by the larger of both values.
  void raise(std::size_t at, std::uint16_t ink) const {
    std::uint16_t& there = m_pixels.inks[at];
    there =
        std::uint16_t(std::max(there & 0xff, ink & 0xff) | std::max(there & 0xff00, ink & 0xff00));
  }
  void put(std::size_t at, std::uint16_t ink, float depth) const {
    raise(at, ink);
    m_pixels.depths[at] = std::clamp(depth, 0.0f, 1.0f);
  }

  static constexpr float least = 0.002f;

  LayerPixels& m_pixels;
  const InkDraw& m_draw;
};

/// Returns the capsules of what is in sight, in order.
std::vector<Capsule> capsulesOf(const LayerPixels& pixels, const InkDraw& draw) {
  constexpr std::size_t grain = 256;
  const std::span<const Stroke> strokes = draw.strokes;
  std::vector<std::vector<Capsule>> parts((strokes.size() + grain - 1) / grain);
  parallelFor(parts.size(), 1, [&](std::size_t part) {
    parts[part].reserve(grain);
    for (std::size_t i = part * grain; i < std::min(strokes.size(), (part + 1) * grain); ++i) {
      const int pieces = inkPieces(strokes[i]);
      for (int piece = 0; piece < pieces; ++piece) {
        const Stroke s = pieces == 1 ? strokes[i] : inkPiece(strokes[i], piece, pieces);
        const std::uint32_t sight = lineSight(pixels, draw, s, inkSteps(s));
        if ((sight & 0xffffu) != 0)
          parts[part].push_back(capsuleOf(draw, s, sight));
      }
    }
  });
  if (parts.size() == 1)
    return std::move(parts.front());
  std::vector<Capsule> capsules;
  for (const std::vector<Capsule>& part : parts)
    capsules.insert(capsules.end(), part.begin(), part.end());
  return capsules;
}

}  // namespace

void drawInk(LayerPixels& pixels, std::span<const InkDraw> draws) {
  std::vector<std::vector<Capsule>> capsules(draws.size());
  for (std::size_t i = 0; i < draws.size(); ++i)
    if (draws[i].kind != InkKind::trims && !draws[i].strokes.empty())
      capsules[i] = capsulesOf(pixels, draws[i]);
  constexpr int bandRows = 48;
  const auto bands = std::size_t((pixels.area.height + bandRows - 1) / bandRows);
  parallelFor(bands, 1, [&](std::size_t band) {
    const int first = pixels.area.y + int(band) * bandRows;
    const int end = std::min(first + bandRows, pixels.area.top());
    for (std::size_t i = 0; i < draws.size(); ++i) {
      if (draws[i].kind == InkKind::trims)
        drawTrims(pixels, draws[i], first, end);
      const CapsuleDrawer drawer(pixels, draws[i]);
      for (const Capsule& capsule : capsules[i])
        if (capsule.bottom < end && capsule.top > first)
          drawer.draw(capsule, first, end);
    }
  });
}

}  // namespace sline::render
