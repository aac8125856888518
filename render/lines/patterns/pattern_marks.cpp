// SPDX-License-Identifier: Apache-2.0
#include "render/lines/patterns/pattern_marks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

namespace sline::render {

namespace {

using model::CutPattern;

/// Numbers that a place of a lattice always gets again.
class PlaceChance {
 public:
  PlaceChance(std::int64_t i, std::int64_t j, std::uint64_t salt)
      : m_state(std::uint64_t(i) * 0x9e3779b97f4a7c15u ^ std::uint64_t(j) * 0xc2b2ae3d27d4eb4fu ^
                (salt + 1) * 0x165667b19e3779f9u) {}
  /// Returns the next number, 0 … 1 (SplitMix64: Steele, Lea and Flood 2014).
  double next() {
    std::uint64_t z = m_state += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return double((z ^ z >> 31) >> 11) * 0x1.0p-53;
  }
  double between(double low, double high) { return low + (high - low) * next(); }
  /// Returns a direction, evenly spread.
  glm::dvec2 direction() {
    const double angle = 2.0 * std::numbers::pi * next();
    return {std::cos(angle), std::sin(angle)};
  }

 private:
  std::uint64_t m_state;
};

glm::dvec2 turned(const glm::dvec2& v) {
  return {-v.y, v.x};
}

/// A lattice of cells along two axes at right angles, through the plane's origin.
struct Lattice {
  glm::dvec2 along{1.0, 0.0};  ///< unit
  glm::dvec2 pitch{1.0};       ///< mm along and across
  bool staggered = false;      ///< every second row stands half a pitch further

  glm::dvec2 place(double i, double j) const {
    return i * pitch.x * along + j * pitch.y * turned(along);
  }
  /// Returns the middle of a cell, moved by up to `jitter` pitches in all along either axis.
  glm::dvec2 seed(std::int64_t i, std::int64_t j, double jitter, PlaceChance& chance) const {
    const double shift = staggered && j % 2 != 0 ? 0.5 : 0.0;
    const double x = double(i) + shift + jitter * (chance.next() - 0.5);
    return place(x, double(j) + jitter * (chance.next() - 0.5));
  }
  /// Calls body(i, j) for all cells with a place in the window, row by row.
  template <class Body>
  void forEach(const PlaneWindow& window, const Body& body) const {
    glm::dvec2 low(1e300);
    glm::dvec2 high(-1e300);
    for (const glm::dvec2& corner :
         {window.low, window.high, glm::dvec2(window.low.x, window.high.y),
          glm::dvec2(window.high.x, window.low.y)}) {
      const glm::dvec2 at(glm::dot(corner, along) / pitch.x,
                          glm::dot(corner, turned(along)) / pitch.y);
      low = glm::min(low, at);
      high = glm::max(high, at);
    }
    for (auto j = std::int64_t(std::floor(low.y)) - 1; double(j) <= high.y + 1.0; ++j)
      for (auto i = std::int64_t(std::floor(low.x)) - 1; double(i) <= high.x + 1.0; ++i)
        body(i, j);
  }
};

class PatternArtist {
 public:
  PatternArtist(const PatternLayout& layout, FacePen& pen)
      : m_layout(layout), m_h(layout.spacing), m_pen(pen), m_window(pen.field().window()) {}

  /// Compact bone is dense along the rim; spongy bone within is a lace of rings.
  void spongy() {
    for (const double distance : {0.34, 0.64, 0.96})
      rimMarks({.distance = distance,
                .pitch = 0.9,
                .length = 1.9 - 0.7 * distance,
                .share = 1.15 - 0.35 * distance,
                .width = {0.4f, 0.6f}});
    scatter(square(1.3), 0.75, 0.0, [&](const glm::dvec2& at, PlaceChance& chance) {
      const double deep = m_pen.field().rim(at) / m_h;
      if (deep < 1.35)
        return;
      const double radius = m_h * chance.between(0.18, 0.5);
      if (chance.next() < 0.78)
        m_pen.loop(pebble(at, radius, chance), {0.4f, 1.0f});
      else
        m_pen.dot(at, float(chance.between(0.5, 0.8)));
    });
    scatter(square(1.3), 0.6, 0.5, [&](const glm::dvec2& at, PlaceChance& chance) {
      if (m_pen.field().rim(at) > 1.3 * m_h && chance.next() < 0.4)
        m_pen.dot(at, float(chance.between(0.4, 0.6)));
    });
  }

  /// Fibres cut along are strokes; the steeper they stand on the face, the shorter.
  void fibres() {
    const double share = std::min(glm::length(m_layout.fibres), 1.0);
    const glm::dvec2 along =
        share > 0.05 ? m_layout.fibres / share : glm::dvec2(std::sqrt(0.5), std::sqrt(0.5));
    const double length = 1.0 + 3.2 * share * share;
    const double stray = 0.6 - 0.48 * share;
    const Lattice rows{.along = along, .pitch = m_h * glm::dvec2(length + 0.8, 0.72)};
    rows.forEach(m_window, [&](std::int64_t i, std::int64_t j) {
      PlaceChance row(0, j, 21);
      PlaceChance chance(i, j, 22);
      const double start = double(i) + row.next() + stray * (chance.next() - 0.5);
      const glm::dvec2 middle =
          rows.place(start, double(j) + (stray + 0.13) * (chance.next() - 0.5));
      if (!near(middle, length))
        return;
      const glm::dvec2 half = 0.5 * m_h * length * chance.between(0.7, 1.05) * along;
      const glm::dvec2 bend = m_h * chance.between(-0.1, 0.1) * turned(along);
      m_pen.curve(waved(middle, half, bend), {0.42f, 0.45f});
    });
  }

  void cells() {
    const Lattice places = honeycomb(1.9);
    const auto seed = [&](std::int64_t i, std::int64_t j) {
      PlaceChance chance(i, j, 31);
      return places.seed(i, j, 0.45, chance);
    };
    places.forEach(m_window, [&](std::int64_t i, std::int64_t j) {
      const glm::dvec2 middle = seed(i, j);
      if (!near(middle, 2.0))
        return;
      std::vector<glm::dvec2> around;
      for (std::int64_t y = -2; y <= 2; ++y)
        for (std::int64_t x = -2; x <= 2; ++x)
          if (x != 0 || y != 0)
            around.push_back(seed(i + x, j + y));
      m_pen.loop(roundedCell(middle, around), {0.36f, 1.0f});
    });
  }

  void waterlines() {
    const Lattice rows{.pitch = m_h * glm::dvec2(7.0, 1.35)};
    rows.forEach(m_window, [&](std::int64_t i, std::int64_t j) {
      PlaceChance row(0, j, 41);
      PlaceChance chance(i, j, 42);
      if (chance.next() > 0.82)
        return;
      const glm::dvec2 middle =
          rows.place(double(i) + row.next() + chance.between(-0.1, 0.1), double(j));
      const glm::dvec2 half(0.5 * m_h * chance.between(2.5, 6.2), 0.0);
      if (near(middle, 6.5))
        m_pen.curve(waved(middle, half, glm::dvec2(0.0)), {0.36f, 0.6f});
    });
  }

  void wall() {
    rimMarks(
        {.distance = 0.6, .pitch = 1.5, .length = 1.45, .share = 0.95, .width = {0.44f, 0.5f}});
    rimMarks({.distance = 1.15, .pitch = 1.7, .length = 1.3, .share = 0.8, .width = {0.4f, 0.5f}});
    rimMarks({.distance = 1.75, .pitch = 2.0, .length = 1.1, .share = 0.5, .width = {0.36f, 0.5f}});
  }

  void rim() {
    rimMarks(
        {.distance = 0.5, .pitch = 1.4, .length = 1.35, .share = 0.95, .width = {0.42f, 0.5f}});
  }

  void lamellae() {
    double deepest = 0.0;
    scatter(square(1.0), 0.0, 0.0, [&](const glm::dvec2& at, PlaceChance&) {
      deepest = std::max(deepest, m_pen.field().rim(at) / m_h);
    });
    for (double distance = 0.65; distance < deepest; distance += 0.72)
      rimMarks({.distance = distance,
                .pitch = 2.2,
                .length = 2.4,
                .share = 0.7,
                .width = {0.38f, 0.5f}});
  }

  /// Cartilage cells lie in pairs.
  void lacunae() {
    scatter(honeycomb(1.75), 0.55, 0.0, [&](const glm::dvec2& at, PlaceChance& chance) {
      const glm::dvec2 along = chance.direction();
      const double reach = 0.17 * m_h * chance.between(0.8, 1.3);
      for (const double side : {-0.24, 0.24}) {
        const glm::dvec2 middle = at + side * m_h * turned(along);
        m_pen.curve(std::array{middle - reach * along, middle + reach * along}, {0.5f, 0.9f});
      }
    });
  }

  void fascicles() {
    scatter(honeycomb(1.5), 0.22, 0.0, [&](const glm::dvec2& at, PlaceChance& chance) {
      m_pen.loop(circle(at, 0.54 * m_h * chance.between(0.85, 1.1)), {0.36f, 1.0f});
      m_pen.dot(at, 0.5f);
    });
  }

  void stipple() {
    scatter(honeycomb(1.3), 0.8, 0.0, [&](const glm::dvec2& at, PlaceChance& chance) {
      m_pen.dot(at, float(chance.between(0.42, 0.62)));
    });
    scatter(square(0.75), 0.9, 0.25, [&](const glm::dvec2& at, PlaceChance& chance) {
      const double deep = m_pen.field().rim(at) / m_h;
      if (chance.next() < 0.9 * (1.0 - deep / 2.6))
        m_pen.dot(at, float(chance.between(0.42, 0.62)));
    });
  }

  void crossed() {
    scatter(square(1.35), 0.6, 0.0, [&](const glm::dvec2& at, PlaceChance& chance) {
      const glm::dvec2 along = chance.direction();
      const glm::dvec2 a = 0.42 * m_h * chance.between(0.8, 1.2) * along;
      const glm::dvec2 b = 0.42 * m_h * chance.between(0.8, 1.2) *
                           glm::normalize(turned(along) + chance.between(-0.4, 0.4) * along);
      m_pen.curve(std::array{at - a, at, at + a}, {0.5f, 0.6f});
      m_pen.curve(std::array{at - b, at, at + b}, {0.5f, 0.6f});
    });
  }

 private:
  /// Strokes along the rim; all lengths are in spacings.
  struct RimRow {
    double distance = 0.5;
    double pitch = 1.0;  ///< of strokes along the row, about
    double length = 1.0;
    double share = 1.0;  ///< of the strokes that are drawn
    MarkWidth width;
  };
  void rimMarks(const RimRow& row) {
    const auto salt = std::uint64_t(std::lround(1000.0 * row.distance));
    const double reach = 0.5 * row.pitch * m_h;
    scatter(square(row.pitch), 0.3, 0.0, [&](const glm::dvec2& at, PlaceChance& chance) {
      PlaceChance own(std::int64_t(chance.next() * 0x1.0p52), 0, salt);
      if (own.next() < row.share)
        m_pen.alongRim({.near = at,
                        .distance = row.distance * m_h,
                        .length = row.length * m_h * own.between(0.75, 1.15),
                        .reach = reach},
                       row.width);
    });
  }

  Lattice square(double pitch) const { return {.pitch = glm::dvec2(pitch * m_h)}; }
  Lattice honeycomb(double pitch) const {
    return {.pitch = pitch * m_h * glm::dvec2(1.0, std::sqrt(0.75)), .staggered = true};
  }

  /// Returns whether a mark around that place with that reach, in spacings, may lie on the face.
  bool near(const glm::dvec2& at, double reach) const {
    if (m_pen.field().rim(at) > 0.0)
      return true;
    const double r = 0.5 * reach * m_h;
    for (const glm::dvec2& d :
         {glm::dvec2(r, 0.0), glm::dvec2(-r, 0.0), glm::dvec2(0.0, r), glm::dvec2(0.0, -r),
          glm::dvec2(0.7 * r, 0.7 * r), glm::dvec2(-0.7 * r, 0.7 * r),
          glm::dvec2(0.7 * r, -0.7 * r), glm::dvec2(-0.7 * r, -0.7 * r)})
      if (m_pen.field().rim(at + d) > 0.0 || m_pen.field().rim(at + 0.5 * d) > 0.0)
        return true;
    return false;
  }

  /// Calls draw(place, chance) for the places of a lattice that lie on the face. `shift` moves the
  /// lattice by that share of its pitch along both axes.
  template <class Draw>
  void scatter(const Lattice& lattice, double jitter, double shift, const Draw& draw) {
    const auto salt = std::uint64_t(std::lround(1000.0 * (shift + lattice.pitch.x / m_h)));
    const glm::dvec2 offset = shift * lattice.pitch;
    lattice.forEach(m_window, [&](std::int64_t i, std::int64_t j) {
      PlaceChance chance(i, j, salt);
      const glm::dvec2 at = lattice.seed(i, j, jitter, chance) + offset;
      if (m_pen.field().rim(at) > 0.0)
        draw(at, chance);
    });
  }

  std::vector<glm::dvec2> circle(const glm::dvec2& middle, double radius) const {
    constexpr int corners = 12;
    std::vector<glm::dvec2> points;
    for (int i = 0; i < corners; ++i) {
      const double angle = 2.0 * std::numbers::pi * double(i) / double(corners);
      points.push_back(middle + radius * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    return points;
  }

  /// Returns a round shape that is longer one way and not quite even.
  std::vector<glm::dvec2> pebble(const glm::dvec2& middle, double radius,
                                 PlaceChance& chance) const {
    const glm::dvec2 along = chance.direction();
    const double stretch = chance.between(1.0, 1.35);
    const double phase = 2.0 * std::numbers::pi * chance.next();
    std::vector<glm::dvec2> points = circle(glm::dvec2(0.0), 1.0);
    for (glm::dvec2& p : points) {
      const double uneven = 1.0 + 0.1 * std::sin(3.0 * std::atan2(p.y, p.x) + phase);
      p = middle + radius * uneven * (stretch * p.x * along + p.y / stretch * turned(along));
    }
    return points;
  }

  /// Returns a stroke from middle − half to middle + half, bent by `bend` in the middle.
  std::vector<glm::dvec2> waved(const glm::dvec2& middle, const glm::dvec2& half,
                                const glm::dvec2& bend) const {
    const double cell = m_pen.field().cell();
    const int steps = std::max(2, int(std::ceil(glm::length(half) / cell)));
    std::vector<glm::dvec2> points;
    for (int i = 0; i <= steps; ++i) {
      const double t = 2.0 * double(i) / double(steps) - 1.0;
      points.push_back(middle + t * half + (1.0 - t * t) * bend);
    }
    return points;
  }

  /// Returns the part of the plane that is nearer to `middle` than to the places around it, a
  /// little smaller and with its corners rounded off (Chaikin 1974).
  std::vector<glm::dvec2> roundedCell(const glm::dvec2& middle,
                                      std::span<const glm::dvec2> around) const {
    const double r = 3.0 * m_h;
    std::vector<glm::dvec2> cell{middle + glm::dvec2(-r, -r), middle + glm::dvec2(r, -r),
                                 middle + glm::dvec2(r, r), middle + glm::dvec2(-r, r)};
    for (const glm::dvec2& other : around)
      cell = nearerHalf(cell, middle, other);
    for (glm::dvec2& p : cell)
      p = middle + 0.93 * (p - middle);
    for (int round = 0; round < 2; ++round) {
      std::vector<glm::dvec2> rounded;
      for (std::size_t i = 0; i < cell.size(); ++i) {
        const glm::dvec2& next = cell[(i + 1) % cell.size()];
        rounded.push_back(glm::mix(cell[i], next, 0.25));
        rounded.push_back(glm::mix(cell[i], next, 0.75));
      }
      cell = std::move(rounded);
    }
    return cell;
  }

  static std::vector<glm::dvec2> nearerHalf(const std::vector<glm::dvec2>& shape,
                                            const glm::dvec2& here, const glm::dvec2& there) {
    const glm::dvec2 n = there - here;
    const double limit = glm::dot(n, 0.5 * (here + there));
    std::vector<glm::dvec2> kept;
    for (std::size_t i = 0; i < shape.size(); ++i) {
      const glm::dvec2& a = shape[i];
      const glm::dvec2& b = shape[(i + 1) % shape.size()];
      const double da = glm::dot(n, a) - limit;
      const double db = glm::dot(n, b) - limit;
      if (da <= 0.0)
        kept.push_back(a);
      if ((da < 0.0 && db > 0.0) || (da > 0.0 && db < 0.0))
        kept.push_back(glm::mix(a, b, da / (da - db)));
    }
    return kept;
  }

  const PatternLayout& m_layout;
  double m_h;
  FacePen& m_pen;
  PlaneWindow m_window;
};

}  // namespace

void drawPattern(CutPattern pattern, const PatternLayout& layout, FacePen& pen) {
  PatternArtist artist(layout, pen);
  switch (pattern) {
    case CutPattern::plain:
    case CutPattern::blank:
      return;
    case CutPattern::spongy:
      return artist.spongy();
    case CutPattern::fibres:
      return artist.fibres();
    case CutPattern::cells:
      return artist.cells();
    case CutPattern::waterlines:
      return artist.waterlines();
    case CutPattern::wall:
      return artist.wall();
    case CutPattern::lamellae:
      return artist.lamellae();
    case CutPattern::lacunae:
      return artist.lacunae();
    case CutPattern::fascicles:
      return artist.fascicles();
    case CutPattern::stipple:
      return artist.stipple();
    case CutPattern::crossed:
      return artist.crossed();
    case CutPattern::rim:
      return artist.rim();
  }
}

}  // namespace sline::render
