// SPDX-License-Identifier: Apache-2.0
// Finds where the dot at a leader's end lies on what it names although little of that is seen: on
// an outline, on a narrow part, between others' lines.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "render/labels/seen/seen_map.h"

namespace sline::render {

namespace {

// Below this share one takes a colour for the ground.
constexpr float faintest = 0.09f;
// How much more of a structure than of any other is to be there, as both are estimates.
constexpr float clearlyMore = 1.2f;
// Strokes on a surface are somewhere near, more seldom just here.
constexpr float strokesHere = 0.5f;
// In λ, half a millimetre on a page of the usual height: whether a leader is dashed follows from
// the picture, not from the paper that it is put on.
constexpr float dotRadius = 1.9f;
// A curve may be drawn so many cells beside where it is here.
constexpr float smoothed = 1.25f;

}  // namespace

/// Tells of each cell of a structure what a dot there would lie on.
struct SeenMap::Dots {
  enum class Shows : std::uint8_t { ground, own, others };
  const SeenLayer& layer;
  int left = 0;
  int top = 0;
  int columns = 0;
  int rows = 0;
  std::vector<Shows> shows;  ///< what one sees in the cell
  std::vector<bool> traces;  ///< something of the structure may be seen
  std::vector<bool> inked;   ///< its outline runs there, seen or not
  std::vector<bool> rivals;  ///< another's line would be seen there, were the structure's own away
  float radius = 1.0f;       ///< cells

  struct Disc {
    float own = 0.0f;
    float others = 0.0f;
    float traces = 0.0f;
    float inked = 0.0f;
    float rivals = 0.0f;
  };
  std::size_t index(int x, int y) const {
    return std::size_t(y - top) * std::size_t(columns) + std::size_t(x - left);
  }
  bool holds(int x, int y) const {
    return x >= left && y >= top && x < left + columns && y < top + rows;
  }
  /// Returns the cell of the greatest worth, of those that `worthOf` gives one.
  template <typename WorthOf>
  std::optional<glm::ivec2> best(WorthOf&& worthOf) const {
    std::optional<glm::ivec2> cell;
    float most = 0.0f;
    for (int y = top; y < top + rows; ++y)
      for (int x = left; x < left + columns; ++x)
        if (const std::optional<float> worth = worthOf(x, y); worth && (!cell || *worth > most)) {
          cell = glm::ivec2(x, y);
          most = *worth;
        }
    return cell;
  }
  /// Tells whether so much of the structure shows around a dot there that one sees what the dot is
  /// on, and not only what it covers: half as much as the dot itself; or nothing else is near.
  bool showsAround(int x, int y) const {
    constexpr float haloed = 1.7f;  // radii, with the light rim around the dot
    constexpr float near = 4.0f;
    constexpr float half = 0.5f;
    constexpr float calm = 0.1f;
    const Disc all = disc(x, y, near * radius);
    return all.others <= calm ||
           all.own * near * near - disc(x, y, haloed * radius).own * haloed * haloed >= half;
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
        disc.inked += inked[i] ? 1.0f : 0.0f;
        disc.rivals += rivals[i] ? 1.0f : 0.0f;
      }
    return {disc.own / all, disc.others / all, disc.traces / all, disc.inked / all,
            disc.rivals / all};
  }
};

SeenMap::Dots SeenMap::dots(std::uint32_t layer) const {
  const SeenLayer& own = m_layers[layer];
  Dots dots{.layer = own,
            .left = own.left(),
            .top = own.top(),
            .columns = own.columns(),
            .rows = own.rows(),
            .shows = {},
            .traces = {},
            .inked = {},
            .rivals = {},
            .radius = dotRadius * lambda() / m_grid.side};
  const std::size_t cells = std::size_t(own.columns()) * std::size_t(own.rows());
  dots.shows.assign(cells, Dots::Shows::ground);
  dots.traces.assign(cells, false);
  dots.inked.assign(cells, false);
  dots.rivals.assign(cells, false);
  constexpr float trace = 0.03f;
  constexpr float rivalling = 0.3f;
  for (int y = own.top(); y < own.top() + own.rows(); ++y)
    for (int x = own.left(); x < own.left() + own.columns(); ++x) {
      const std::size_t i = dots.index(x, y);
      if (covered(x, y)) {
        dots.shows[i] = Dots::Shows::others;
        continue;
      }
      const Shares shares = sharesAt(own, layer, x, y);
      dots.traces[i] = shares.traces > trace;
      dots.inked[i] = own.at(x, y).ink > trace;
      dots.rivals[i] = shares.rivals > rivalling;
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
  float without = 1.0f;  // what is left where the structure itself is not reckoned with
  float bare = 1.0f;     // the chance that no line on another surface is there
  float clear = 1.0f;    // the chance that no line on a surface before it covers it
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
    if (!passed && own.mayLieBefore(mine, cellOf(one, x, y))) {
      const float before = left;
      shares.traces = std::max(shares.traces, pass(own, mine, mine.ink, 0.0f));
      left = before;
    }
    if (!passed && mine.depth < one.depth && !own.touches(mine, cellOf(one, x, y))) {
      shares.own = clear * pass(own, mine, mine.ink, 0.0f);
      passed = true;
    }
    const SeenLayer& other = m_layers[one.layer];
    const SeenCell& cell = other.at(x, y);
    shares.rivals = std::max(shares.rivals, without * cell.ink);
    if (cell.what == SeenCell::What::surface)
      bare *= 1.0f - without * other.look().lines();
    without *= (1.0f - other.fillOf(cell).cover) * (1.0f - cell.ink);
    if (!passed && cell.what == SeenCell::What::surface)
      clear *= 1.0f - strokesHere * left * other.look().lines();
    const float strokes =
        cell.what == SeenCell::What::surface ? strokesHere * left * other.look().strokes() : 0.0f;
    shares.others = std::max(shares.others, strokes);
    // It may be bent there, and show and hide more.
    shares.others = std::max(shares.others, pass(other, cell, cell.ink, 1.0f));
  }
  if (!passed)
    shares.own = clear * pass(own, mine, mine.ink, 0.0f);
  shares.traces = std::max(shares.traces, shares.own);
  shares.rivals = std::max(shares.rivals, 1.0f - bare);
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
  constexpr float much = 0.5f;
  constexpr float enough = 0.3f;
  constexpr float calm = 0.1f;
  constexpr float tangled = 0.3f;
  constexpr float leads = 1.5f;  // where lines of two run together, either may be the one on top
  const float dear = near ? 0.03f : 0.002f;  // a way of one cell
  const float wide = all.radius + smoothed;
  const auto clear = [&](int x, int y) -> std::optional<float> {
    if (all.shows[all.index(x, y)] != Dots::Shows::own)
      return std::nullopt;
    const Dots::Disc dot = all.disc(x, y, all.radius);
    if (dot.own < enough || dot.own < leads * dot.others)
      return std::nullopt;
    const Dots::Disc around = all.disc(x, y, wide);
    if ((dot.own < much && around.others > calm) || !all.showsAround(x, y))
      return std::nullopt;
    // A narrow strip is surest away from its ends.
    const float along = all.disc(x, y, 3.0f * all.radius).own;
    const float far = was ? glm::length(m_grid.middle(x, y) - *was) / m_grid.side : 0.0f;
    return dot.own + 0.3f * (around.own + along - dot.rivals) - 0.6f * around.others -
           dear * std::min(far, 100.0f);
  };
  std::optional<glm::ivec2> best = all.best(clear);
  const std::optional<glm::ivec2> hidden = best ? std::nullopt : hiddenCell(all);
  // Where a sliver is all there is, its outline is everywhere and seen a little. What others
  // outshine in the whole of every dot is not seen.
  constexpr float little = 0.15f;
  constexpr float least = 0.1f;  // of a dot
  if (hidden && all.inked[all.index(hidden->x, hidden->y)] &&
      sharesAt(all.layer, layer, hidden->x, hidden->y).traces > little)
    best = all.best([&](int x, int y) -> std::optional<float> {
      const Dots::Disc dot = all.disc(x, y, all.radius);
      return dot.own > least && all.showsAround(x, y)
                 ? std::optional(dot.own + dot.traces - dot.others)
                 : std::nullopt;
    });
  // Ink lies outside the surface: the place on it is beside the dot.
  const auto on = best ? all.layer.coveredNear(best->x, best->y, 4) : std::nullopt;
  if (on) {
    SeenPlace place = placeAt(all.layer, on->x, on->y, false);
    place.place = m_grid.middle(best->x, best->y);
    const Dots::Disc dot = all.disc(best->x, best->y, all.radius);
    place.sure = dot.own >= much && dot.rivals <= tangled;
    return place;
  }
  const std::optional<glm::ivec2> place = hidden ? hidden : hiddenCell(all);
  return place ? std::optional(placeAt(all.layer, place->x, place->y, true)) : std::nullopt;
}

std::optional<glm::ivec2> SeenMap::hiddenCell(const Dots& all) const {
  const glm::vec2 middle(float(all.left) + 0.5f * float(all.columns),
                         float(all.top) + 0.5f * float(all.rows));
  const float wide = all.radius + smoothed;
  const float size = std::max(float(std::max(all.columns, all.rows)), 1.0f);
  return all.best([&](int x, int y) -> std::optional<float> {
    if (!all.layer.covers(x, y))
      return std::nullopt;
    const Dots::Disc around = all.disc(x, y, wide);
    constexpr float nowhere = 10.0f;  // a leader that ends there is not drawn
    return (covered(x, y) ? -nowhere : 0.0f) + around.others - 4.0f * around.traces -
           0.5f * around.inked - glm::length(glm::vec2(float(x), float(y)) - middle) / size;
  });
}

}  // namespace sline::render
