// SPDX-License-Identifier: Apache-2.0
// Finds where the dot at a leader's end lies on what it names although little of that is seen: on
// an outline, on a narrow part, between others' lines.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "render/labels/seen_map.h"

namespace sline::render {

namespace {

// Below this share one takes a colour for the ground.
constexpr float faintest = 0.09f;
// How much more of a structure than of any other is to be there, as both are estimates.
constexpr float clearlyMore = 1.2f;
// Strokes on a surface are somewhere near, more seldom just here.
constexpr float strokesHere = 0.5f;
constexpr float dotRadius = 0.5f;  // millimetres
// A drawn outline is a smoothed curve, which lies up to so many cells beside the surface's own.
constexpr float smoothed = 1.25f;

}  // namespace

/// Tells of each cell of a structure what a dot there would lie on.
struct SeenMap::Dots {
  enum class Shows : std::uint8_t { ground, own, others };
  SeenLayer layer;  ///< as pictures have it
  int left = 0;
  int top = 0;
  int columns = 0;
  int rows = 0;
  std::vector<Shows> shows;  ///< what one sees in the cell
  std::vector<bool> traces;  ///< something of the structure is seen
  float radius = 1.0f;       ///< cells

  struct Disc {
    float own = 0.0f;
    float others = 0.0f;
    float traces = 0.0f;
  };
  std::size_t index(int x, int y) const {
    return std::size_t(y - top) * std::size_t(columns) + std::size_t(x - left);
  }
  bool holds(int x, int y) const {
    return x >= left && y >= top && x < left + columns && y < top + rows;
  }
  /// Returns the shares of a disc around a cell.
  Disc disc(int x, int y, float size) const {
    Disc disc;
    float all = 0.0f;
    const int reach = int(size);
    for (int dy = -reach; dy <= reach; ++dy)
      for (int dx = -reach; dx <= reach; ++dx) {
        if (float(dx * dx + dy * dy) > size * size)
          continue;
        all += 1.0f;
        if (!holds(x + dx, y + dy))
          continue;
        const std::size_t i = index(x + dx, y + dy);
        disc.own += shows[i] == Shows::own ? 1.0f : 0.0f;
        disc.others += shows[i] == Shows::others ? 1.0f : 0.0f;
        disc.traces += traces[i] ? 1.0f : 0.0f;
      }
    return {disc.own / all, disc.others / all, disc.traces / all};
  }
};

SeenMap::Dots SeenMap::dots(std::uint32_t layer) const {
  SeenLayer own = m_layers[layer].undrawn();
  own.drawAsInPictures(m_scene, m_screen, m_grid);
  Dots dots{.layer = own,
            .left = own.left(),
            .top = own.top(),
            .columns = own.columns(),
            .rows = own.rows(),
            .shows = {},
            .traces = {},
            .radius = dotRadius / m_grid.side};
  const std::size_t cells = std::size_t(own.columns()) * std::size_t(own.rows());
  dots.shows.assign(cells, Dots::Shows::ground);
  dots.traces.assign(cells, false);
  constexpr float trace = 0.03f;
  for (int y = own.top(); y < own.top() + own.rows(); ++y)
    for (int x = own.left(); x < own.left() + own.columns(); ++x) {
      const Shares shares = sharesAt(own, layer, x, y);
      const std::size_t i = dots.index(x, y);
      dots.traces[i] = shares.own > trace;
      if (shares.own > faintest && shares.own >= clearlyMore * shares.others)
        dots.shows[i] = Dots::Shows::own;
      else if (shares.others > faintest)
        dots.shows[i] = Dots::Shows::others;
    }
  return dots;
}

SeenMap::Shares SeenMap::sharesAt(const SeenLayer& own, std::uint32_t layer, int x, int y) const {
  Shares shares;
  float left = 1.0f;
  const auto pass = [&](const SeenLayer& of, const SeenCell& cell, float ink, float bent) {
    const SeenFill fill = of.fillOf(cell, bent);
    const float share = left * (ink + (1.0f - ink) * fill.colour);
    left *= (1.0f - fill.cover) * (1.0f - ink);
    return share;
  };
  const SeenCell& mine = own.at(x, y);
  bool passed = mine.what == SeenCell::What::nothing;
  for (const Fragment& one : fragments(x, y)) {
    if (one.layer == layer)
      continue;
    if (!passed && mine.depth < one.depth && !own.touches(mine.depth, one.depth)) {
      shares.own = pass(own, mine, mine.ink, 0.0f);
      passed = true;
    }
    const SeenLayer& other = m_layers[one.layer];
    const SeenCell& cell = other.at(x, y);
    const float strokes =
        cell.what == SeenCell::What::surface ? strokesHere * left * other.look().strokes() : 0.0f;
    shares.others = std::max(shares.others, strokes);
    // It may be bent there, and show and hide more.
    shares.others =
        std::max(shares.others, pass(other, cell, cell.ink * other.look().outline(), 1.0f));
  }
  if (!passed)
    shares.own = pass(own, mine, mine.ink, 0.0f);
  return shares;
}

SeenPlace SeenMap::placeAt(const SeenLayer& own, int x, int y, bool hidden) const {
  const SeenLayer::Spot found = own.spotAt(m_screen, m_grid, x, y);
  return {found.anchor, found.place, hidden};
}

std::optional<SeenPlace> SeenMap::dotPlace(std::uint32_t layer,
                                           const std::optional<model::Anchor>& before,
                                           bool near) const {
  const Dots all = dots(layer);
  std::optional<glm::vec2> was;
  if (before)
    if (const std::optional<glm::vec3> p = m_scene.placeOf(*before))
      was = m_screen.place(*p);
  struct Best {
    int x;
    int y;
    float worth;
  };
  std::optional<Best> best;
  constexpr float much = 0.5f;
  constexpr float enough = 0.3f;
  constexpr float calm = 0.1f;
  const float dear = near ? 0.03f : 0.002f;  // a way of one cell
  const float wide = all.radius + smoothed;
  for (int y = all.top; y < all.top + all.rows; ++y)
    for (int x = all.left; x < all.left + all.columns; ++x) {
      if (all.shows[all.index(x, y)] != Dots::Shows::own)
        continue;
      const Dots::Disc dot = all.disc(x, y, all.radius);
      if (dot.own < enough)
        continue;
      const Dots::Disc around = all.disc(x, y, wide);
      if (dot.own < much && around.others > calm)
        continue;
      const float far = was ? glm::length(m_grid.middle(x, y) - *was) / m_grid.side : 0.0f;
      const float worth =
          dot.own + 0.3f * around.own - 0.6f * around.others - dear * std::min(far, 100.0f);
      if (!best || worth > best->worth)
        best = Best{x, y, worth};
    }
  if (!best)
    return hiddenPlace(all);
  // Ink lies outside the surface: the place on it is beside the dot.
  const std::optional<glm::ivec2> on = all.layer.coveredNear(best->x, best->y, 4);
  if (!on)
    return hiddenPlace(all);
  SeenPlace place = placeAt(all.layer, on->x, on->y, false);
  place.place = m_grid.middle(best->x, best->y);
  return place;
}

std::optional<SeenPlace> SeenMap::hiddenPlace(const Dots& all) const {
  struct Best {
    int x;
    int y;
    float worth;
  };
  std::optional<Best> best;
  const SeenLayer& own = all.layer;
  const glm::vec2 middle(float(all.left) + 0.5f * float(all.columns),
                         float(all.top) + 0.5f * float(all.rows));
  const float wide = all.radius + smoothed;
  const float size = std::max(float(std::max(all.columns, all.rows)), 1.0f);
  for (int y = all.top; y < all.top + all.rows; ++y)
    for (int x = all.left; x < all.left + all.columns; ++x) {
      if (!own.covers(x, y))
        continue;
      const Dots::Disc around = all.disc(x, y, wide);
      const float worth = around.others - 4.0f * around.traces -
                          glm::length(glm::vec2(float(x), float(y)) - middle) / size;
      if (!best || worth > best->worth)
        best = Best{x, y, worth};
    }
  return best ? std::optional(placeAt(all.layer, best->x, best->y, true)) : std::nullopt;
}

}  // namespace sline::render
