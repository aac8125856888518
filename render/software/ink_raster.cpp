// SPDX-License-Identifier: Apache-2.0
#include "render/software/ink_raster.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "model/base/lanes.h"
#include "model/base/parallel.h"
#include "render/drawn/fill_shading.h"
#include "render/raster/rounding.h"
#include "render/sight/rules.h"
#include "render/software/line_sight.h"
#include "render/software/trims.h"

namespace sline::render {

namespace {

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
  c.a = c.penA + s.outwardA * rule::penOutside(s.halfWidthA);
  const glm::vec2 b = c.penB + s.outwardB * rule::penOutside(s.halfWidthB);
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
               ? rule::depthLift(0.5f * (s.depthA + s.depthB), 2.0f * s.tolerance, draw.projection)
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

/// Four pixels of a row that follow each other, of which some belong to a capsule.
struct FourSpots {
  Lanes x;  ///< the pixels' middles
  float y;
  Lanes t, distance;  ///< see Spot
  int column, row;    ///< of the first pixel
  std::size_t at;     ///< in the layer
  unsigned inside;    ///< a bit for each that belongs to the capsule

  Spot spot(std::size_t lane) const { return {{x[lane], y}, t[lane], distance[lane], at + lane}; }
};

float mixed(float a, float b, float t) {
  return a + t * (b - a);
}
Lanes mixed(float a, float b, Lanes t) {
  return a + t * (b - a);
}

Lanes clamped(Lanes value, float low, float high) {
  return smaller(larger(value, Lanes{} + low), Lanes{} + high);
}

/// Returns the nearest whole numbers of numbers of 0 or more.
WholeLanes wholesOf(Lanes numbers) {
  return __builtin_convertvector(numbers + 0.5f, WholeLanes);
}

/// Calls body(lane) for each bit.
template <class Body>
void forEachBit(unsigned bits, const Body& body) {
  for (; bits != 0; bits &= bits - 1)
    body(std::size_t(std::countr_zero(bits)));
}

/// Draws capsules of one kind, row by row.
class CapsuleDrawer {
 public:
  CapsuleDrawer(LayerPixels& pixels, const InkDraw& draw) : m_pixels(pixels), m_draw(draw) {}

  /// Draws those rows of the capsule that lie in first … end − 1.
  void draw(const Capsule& c, int first, int end) const {
    switch (m_draw.kind) {
      case InkKind::surfaceLines:
        forEachFour(c, first, end, [&](const FourSpots& spots) { surfaceLine(c, spots); });
        break;
      case InkKind::contours:
      case InkKind::hidden:
        forEachFour(c, first, end, [&](const FourSpots& spots) { contour(c, spots); });
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
  void forEachFour(const Capsule& c, int first, int end, const Body& body) const {
    const PixelRect& area = m_pixels.area;
    const float perLength = c.length > 1e-6f ? 1.0f / c.length : 0.0f;
    for (int y = std::max(c.bottom, first); y < std::min(c.top, end); ++y) {
      const float dy = float(y) + 0.5f - c.a.y;
      glm::vec2 span(float(area.x) + 0.5f - c.a.x, float(area.right()) - 0.5f - c.a.x);
      narrow({c.along.x, c.perAlong.x}, dy * c.along.y, -c.beyond.x, c.length + c.beyond.y, span);
      narrow({-c.along.y, -c.perAlong.y}, dy * c.along.x, -c.reach, c.reach, span);
      if (span.x > span.y)
        continue;
      const int left = int(std::ceil(span.x + c.a.x - 0.5f));
      const int right = int(std::floor(span.y + c.a.x - 0.5f));
      for (int x = left; x <= right; x += int(laneCount)) {
        const Lanes columns = float(x) + Lanes{0.0f, 1.0f, 2.0f, 3.0f};
        const Lanes dx = columns + 0.5f - c.a.x;
        const Lanes way = dx * c.along.x + dy * c.along.y;
        const Lanes across = dy * c.along.x - dx * c.along.y;
        const Lanes outside = way - clamped(way, 0.0f, c.length);
        const Lanes t = clamped(way * perLength, 0.0f, 1.0f);
        const Lanes distance = squareRoot(across * across + outside * outside);
        const unsigned inside = bitsOf((distance < mixed(c.halfWidthA, c.halfWidthB, t) + 0.5f) &
                                       (columns <= float(right)));
        if (inside != 0)
          body(FourSpots{columns + 0.5f, float(y) + 0.5f, t, distance, x, y, m_pixels.at(x, y),
                         inside});
      }
    }
  }
  template <class Body>
  void forEachSpot(const Capsule& c, int first, int end, const Body& body) const {
    forEachFour(c, first, end, [&](const FourSpots& spots) {
      forEachBit(spots.inside, [&](std::size_t lane) { body(spots.spot(lane)); });
    });
  }

  /// Returns the bits of the place that is nearest to the spot's.
  static std::uint32_t sightAt(const Capsule& c, float t) {
    return c.sight >> nearestWhole(t * float(c.steps));
  }
  static glm::vec2 outwardAt(const Capsule& c, float t) {
    return glm::normalize(glm::mix(c.outwardA, c.outwardB, t) + glm::vec2(1e-6f, 0.0f));
  }
  /// Returns what remains of the spots where the capsule is in sight.
  static unsigned inSight(const Capsule& c, const FourSpots& spots) {
    const std::uint32_t all = (2u << c.steps) - 1u;
    if ((c.sight & all) == all)
      return spots.inside;
    unsigned seen = 0;
    forEachBit(spots.inside,
               [&](std::size_t lane) { seen |= (sightAt(c, spots.t[lane]) & 1u) << lane; });
    return seen;
  }
  Lanes grained(Lanes coverage, const FourSpots& spots) const {
    if (m_draw.grain > 0.0f)
      for (std::size_t lane = 0; lane < laneCount; ++lane)
        coverage[lane] *=
            rule::inkTaken({spots.x[lane], spots.y}, {m_draw.grain, m_draw.grainSize});
    return coverage;
  }

  void surfaceLine(const Capsule& c, const FourSpots& spots) const {
    const unsigned seen = inSight(c, spots);
    if (seen == 0)
      return;
    const Lanes halfWidth = mixed(c.halfWidthA, c.halfWidthB, spots.t);
    const Lanes coverage = grained(wide_rule::penCoverage(halfWidth, spots.distance, c.edge) *
                                       mixed(c.opacityA, c.opacityB, spots.t),
                                   spots);
    put(spots.at, seen & bitsOf(coverage > least), coverage, mixed(c.depthA, c.depthB, spots.t));
  }

  /// Tells at which of the spots a contour runs within its surface's own mask, away from the pen.
  LaneMask within(const Capsule& c, const FourSpots& spots, unsigned seen, Lanes apart2) const {
    const float step = float(m_pixels.step());
    const unsigned apart = bitsOf(apart2 > step * step);
    WholeLanes result{};
    forEachBit(seen, [&](std::size_t lane) {
      const bool inner =
          (sightAt(c, spots.t[lane]) & 0x10000u) != 0 ||
          ((apart >> lane & 1u) != 0 &&
           m_pixels.surfaceDepths[m_pixels.samples.at({spots.column + int(lane), spots.row})] <
               1.0f);
      result[lane] = inner ? -1 : 0;
    });
    return result;
  }

  void contour(const Capsule& c, const FourSpots& spots) const {
    const unsigned seen = inSight(c, spots);
    if (seen == 0)
      return;
    Lanes halfWidth = mixed(c.halfWidthA, c.halfWidthB, spots.t);
    Lanes opacity = mixed(c.opacityA, c.opacityB, spots.t);
    Lanes distance = spots.distance;
    if (c.inner < 1.0f) {
      const Lanes fromX = spots.x - mixed(c.penA.x, c.penB.x, spots.t);
      const Lanes fromY = spots.y - mixed(c.penA.y, c.penB.y, spots.t);
      const LaneMask inner = within(c, spots, seen, fromX * fromX + fromY * fromY);
      const Lanes thin = halfWidth * c.inner;
      const Lanes narrower = wide_rule::penHalfWidth(thin);
      const Lanes outX = mixed(c.outwardA.x, c.outwardB.x, spots.t) + 1e-6f;
      const Lanes outY = mixed(c.outwardA.y, c.outwardB.y, spots.t);
      const Lanes out = wide_rule::penOutside(narrower) / squareRoot(outX * outX + outY * outY);
      const Lanes awayX = fromX - outX * out;
      const Lanes awayY = fromY - outY * out;
      halfWidth = inner ? narrower : halfWidth;
      opacity = inner ? opacity * wide_rule::penOpacity(thin) : opacity;
      distance = inner ? squareRoot(awayX * awayX + awayY * awayY) : distance;
    }
    const Lanes coverage =
        grained(wide_rule::penCoverage(halfWidth, distance, 1.0f) * opacity, spots);
    const unsigned inked = seen & bitsOf(coverage > least);
    if (m_draw.kind == InkKind::hidden) {
      const WholeLanes bytes =
          wholesOf(255.0f * clamped(rule::hiddenStored * coverage, 0.0f, 1.0f));
      forEachBit(inked, [&](std::size_t lane) {
        raise(spots.at + lane, std::uint16_t(bytes[lane] << 8));
      });
      return;
    }
    const Lanes depth = mixed(c.depthA, c.depthB, spots.t);
    put(spots.at, inked, coverage, smaller(larger(depth - c.lift, Lanes{}), depth));
  }

  void halo(const Capsule& c, const Spot& spot) const {
    if (spot.distance >= mixed(c.halfWidthA, c.halfWidthB, spot.t) ||
        (sightAt(c, spot.t) & 1u) == 0 || m_pixels.surfaceDepthAt(spot.pixel) < 1.0f)
      return;
    put(spot.at, 0xff00, mixed(c.depthA, c.depthB, spot.t));
  }

  void edge(const Capsule& c, const Spot& spot) const {
    if ((sightAt(c, spot.t) & 1u) == 0)
      return;
    const float depth = mixed(c.depthA, c.depthB, spot.t);
    float coverage =
        rule::penCoverage(mixed(c.halfWidthA, c.halfWidthB, spot.t), spot.distance, 1.0f) *
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

  void put(std::size_t at, unsigned bits, Lanes coverage, Lanes depth) const {
    const WholeLanes bytes = wholesOf(255.0f * clamped(coverage, 0.0f, 1.0f));
    const Lanes stored = clamped(depth, 0.0f, 1.0f);
    forEachBit(bits, [&](std::size_t lane) {
      raise(at + lane, std::uint16_t(bytes[lane]));
      m_pixels.depths[at + lane] = stored[lane];
    });
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

constexpr int bandRows = 32;

std::size_t bandCount(const PixelRect& area) {
  return std::size_t((area.height + bandRows - 1) / bandRows);
}

/// Lists what is drawn to each band of rows, in order.
class BandLists {
 public:
  explicit BandLists(const PixelRect& area) : m_area(area), m_lists(bandCount(area)) {}

  /// Adds what lies in some rows, the last one not included.
  void add(std::size_t what, int bottom, int top) {
    const int first = std::max(bottom, m_area.y) - m_area.y;
    const int end = std::min(top, m_area.top()) - m_area.y;
    if (first < end)
      for (int band = first / bandRows; band <= (end - 1) / bandRows; ++band)
        m_lists[std::size_t(band)].push_back(std::uint32_t(what));
  }
  /// Returns what is drawn to the band that starts at a row.
  std::span<const std::uint32_t> of(int first) const {
    return m_lists[std::size_t((first - m_area.y) / bandRows)];
  }

 private:
  PixelRect m_area;
  std::vector<std::vector<std::uint32_t>> m_lists;
};

}  // namespace

void forEachBand(const PixelRect& area, const ReadyRows& ready) {
  parallelFor(bandCount(area), 1, [&](std::size_t band) {
    const int first = area.y + int(band) * bandRows;
    ready(first, std::min(first + bandRows, area.top()));
  });
}

void drawInk(LayerPixels& pixels, std::span<const InkDraw> draws, const ReadyRows& ready) {
  std::vector<std::vector<Capsule>> capsules(draws.size());
  std::vector<BandLists> lists(draws.size(), BandLists(pixels.area));
  for (std::size_t i = 0; i < draws.size(); ++i) {
    if (draws[i].kind == InkKind::trims) {
      const Trimmer trimmer(pixels, draws[i]);
      for (std::size_t k = 0; k < draws[i].strokes.size(); ++k) {
        const glm::ivec2 rows = trimmer.rows(draws[i].strokes[k]);
        lists[i].add(k, rows.x, rows.y);
      }
    } else if (!draws[i].strokes.empty()) {
      capsules[i] = capsulesOf(pixels, draws[i]);
      for (std::size_t k = 0; k < capsules[i].size(); ++k)
        lists[i].add(k, capsules[i][k].bottom, capsules[i][k].top);
    }
  }
  forEachBand(pixels.area, [&](int first, int end) {
    ready(first, end);
    for (std::size_t i = 0; i < draws.size(); ++i) {
      const Trimmer trimmer(pixels, draws[i]);
      const CapsuleDrawer drawer(pixels, draws[i]);
      for (const std::uint32_t k : lists[i].of(first))
        if (draws[i].kind == InkKind::trims)
          trimmer.draw(draws[i].strokes[k], first, end);
        else
          drawer.draw(capsules[i][k], first, end);
    }
  });
}

}  // namespace sline::render
