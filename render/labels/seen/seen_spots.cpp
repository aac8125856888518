// SPDX-License-Identifier: Apache-2.0
// Chooses among the places where a picture shows a structure.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "render/labels/seen/seen_map.h"

namespace sline::render {

/// Holds what each cell of a structure is worth.
struct SeenMap::Candidates {
  std::uint32_t layer = 0;
  int left = 0;
  int top = 0;
  int columns = 0;
  int rows = 0;
  std::vector<Worth> worth;
  std::vector<bool> firm;  ///< faces the eye, and no fold is near
  std::vector<bool> cut;   ///< on a coloured cut face of its own, which shows more than any other

  std::size_t size() const { return worth.size(); }
  int x(std::size_t i) const { return left + int(i % std::size_t(columns)); }
  int y(std::size_t i) const { return top + int(i / std::size_t(columns)); }
  std::optional<std::size_t> indexAt(int atX, int atY) const {
    if (atX < left || atY < top || atX >= left + columns || atY >= top + rows)
      return std::nullopt;
    return std::size_t(atY - top) * std::size_t(columns) + std::size_t(atX - left);
  }
};

namespace {

struct Spot {
  std::size_t cell = 0;
  float depth = 0.0f;  ///< cells from where cells do not count
};

/// Returns how far each cell is from one that does not count, with two sweeps (Borgefors: Distance
/// transformations in digital images, 1986).
std::vector<float> depths(const std::vector<bool>& counts, int columns, int rows) {
  std::vector<float> depth(counts.size());
  constexpr float diagonal = 1.41421356f;
  const auto at = [columns](int x, int y) {
    return std::size_t(y) * std::size_t(columns) + std::size_t(x);
  };
  const auto relax = [&](int x, int y, int way) {
    const auto from = [&](int dx, int dy, float cost) {
      const int nx = x + dx;
      const int ny = y + dy;
      const bool inside = nx >= 0 && ny >= 0 && nx < columns && ny < rows;
      return (inside ? depth[at(nx, ny)] : 0.0f) + cost;
    };
    depth[at(x, y)] = std::min({depth[at(x, y)], from(-way, 0, 1.0f), from(0, -way, 1.0f),
                                from(-way, -way, diagonal), from(way, -way, diagonal)});
  };
  for (std::size_t i = 0; i < counts.size(); ++i)
    depth[i] = counts[i] ? std::numeric_limits<float>::infinity() : 0.0f;
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x)
      relax(x, y, 1);
  for (int y = rows; y-- > 0;)
    for (int x = columns; x-- > 0;)
      relax(x, y, -1);
  return depth;
}

/// Returns the deepest cell that counts; of equally deep ones the nearest to the middle of all.
std::optional<Spot> deepest(const std::vector<bool>& counts, int columns, int rows) {
  const std::vector<float> depth = depths(counts, columns, rows);
  const auto place = [columns](std::size_t i) {
    const std::size_t row = i / std::size_t(columns);
    return glm::vec2(float(i % std::size_t(columns)), float(row));
  };
  glm::vec2 middle(0.0f);
  float number = 0.0f;
  for (std::size_t i = 0; i < counts.size(); ++i)
    if (counts[i]) {
      middle += place(i);
      number += 1.0f;
    }
  std::optional<Spot> best;
  float bestWorth = 0.0f;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (!counts[i])
      continue;
    const float worth = depth[i] - 0.02f * glm::length(place(i) - middle / number);
    if (!best || worth > bestWorth) {
      best = Spot{i, depth[i]};
      bestWorth = worth;
    }
  }
  return best;
}

/// Returns the cell nearest to that place, of all that count and are as deep as that.
std::optional<Spot> nearest(const std::vector<bool>& counts, int columns, float room,
                            const glm::vec2& towards) {
  const auto width = std::size_t(columns);
  const std::vector<float> depth = depths(counts, columns, int(counts.size() / width));
  std::optional<Spot> best;
  float least = 0.0f;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const std::size_t row = i / width;
    const float far = glm::distance(glm::vec2(float(i % width), float(row)), towards);
    if (counts[i] && depth[i] >= room && (!best || far < least)) {
      best = Spot{i, depth[i]};
      least = far;
    }
  }
  return best;
}

}  // namespace

SeenMap::Candidates SeenMap::candidates(std::uint32_t layer) const {
  const SeenLayer& own = m_layers[layer];
  Candidates all{.layer = layer,
                 .left = own.left(),
                 .top = own.top(),
                 .columns = own.columns(),
                 .rows = own.rows(),
                 .worth = {},
                 .firm = {},
                 .cut = {}};
  const std::size_t cells = std::size_t(own.columns()) * std::size_t(own.rows());
  all.worth.resize(cells);
  all.firm.resize(cells);
  all.cut.resize(cells);
  constexpr float oblique = 0.3f;
  for (std::size_t i = 0; i < cells; ++i) {
    const int x = all.x(i);
    const int y = all.y(i);
    all.worth[i] = worthOf(layer, x, y);
    const SeenCell& cell = own.at(x, y);
    all.firm[i] = own.covers(x, y) && !cell.outline && cell.facing >= oblique;
    all.cut[i] =
        cell.what == SeenCell::What::cutFace && !own.isPaper(cell) && all.worth[i] >= Worth::most;
  }
  return all;
}

std::optional<SeenPlace> SeenMap::kept(const Candidates& all, const model::Anchor& before,
                                       bool onFace) const {
  const std::optional<glm::vec3> p = m_scene.placeOf(before);
  const std::optional<glm::vec2> place = p ? m_screen.place(*p) : std::nullopt;
  if (!place || !m_screen.inside(*place))
    return std::nullopt;
  const int x = int(std::floor(place->x / m_grid.side));
  const int y = int(std::floor(place->y / m_grid.side));
  const std::optional<std::size_t> index = all.indexAt(x, y);
  const std::optional<Worth> worth = index ? std::optional(all.worth[*index]) : std::nullopt;
  if (!worth || *worth <= Worth::slim || *worth == Worth::outline || (onFace && !all.cut[*index]))
    return std::nullopt;
  // The surface that is seen there is that of the place.
  const SeenLayer& own = m_layers[all.layer];
  const float near = 0.03f * glm::length(own.node().mesh->bounds().size());
  const glm::vec3 seen =
      m_scene.placeOf(own.spotAt(m_screen, m_grid, x, y).anchor).value_or(glm::vec3(1e9f));
  const float cellMm = glm::length(seen - *p);
  const Worth best = *std::max_element(all.worth.begin(), all.worth.end());
  if (cellMm > near || (*worth < best && *worth < Worth::most))
    return std::nullopt;
  return SeenPlace{before, *place, false};
}

std::optional<SeenPlace> SeenMap::find(model::NodeId structure,
                                       const std::optional<model::Anchor>& before,
                                       bool near) const {
  const auto index = m_index.find(structure);
  if (index == m_index.end() || m_layers[index->second].columns() == 0)
    return std::nullopt;
  const Candidates all = candidates(index->second);
  // Where a section shows the structure's inside, that is what the picture is made for.
  constexpr float roomOnFace = 3.6f;  // λ: a dot must not cover what it is on
  const auto face = deepest(all.cut, all.columns, all.rows);
  const bool onFace = face && face->depth * m_grid.side >= roomOnFace * lambda();
  if (before)
    if (std::optional<SeenPlace> stays = kept(all, *before, onFace))
      return stays;
  const auto spotOf = [&](auto&& is, bool firm) {
    std::vector<bool> counts(all.size());
    for (std::size_t i = 0; i < all.size(); ++i)
      counts[i] = is(all.worth[i]) && (!firm || all.firm[i]);
    return deepest(counts, all.columns, all.rows);
  };
  std::optional<glm::vec2> towards;  // in cells
  if (const std::optional<glm::vec3> p = near && before ? m_scene.placeOf(*before) : std::nullopt)
    if (const std::optional<glm::vec2> was = m_screen.place(*p))
      towards = *was / m_grid.side - glm::vec2(float(all.left), float(all.top)) - 0.5f;
  const auto nearSpot = [&](auto&& is, bool firm, float room) {
    std::vector<bool> counts(all.size());
    for (std::size_t i = 0; i < all.size(); ++i)
      counts[i] = is(all.worth[i]) && (!firm || all.firm[i]);
    return nearest(counts, all.columns, room, *towards);
  };
  constexpr float roomForDot = 4.5f;  // λ
  const float enough = roomForDot * lambda() / m_grid.side;
  if (onFace) {
    const auto spot =
        towards ? nearest(all.cut, all.columns, std::min(enough, face->depth), *towards) : face;
    return placeAt(m_layers[all.layer], all.x(spot->cell), all.y(spot->cell), false);
  }
  // A corner that lies beyond everything else is no place for a structure that is seen at large.
  constexpr float cornerShare = 0.4f;
  const auto isPlain = [](Worth worth) { return worth >= Worth::most; };
  const auto plain = spotOf(isPlain, false);
  const float ownRoom = plain ? cornerShare * plain->depth : 0.0f;
  for (const Worth worth : {Worth::alone, Worth::most}) {
    const auto is = [worth](Worth one) { return one >= worth; };
    const float room = worth == Worth::alone ? std::max(enough, ownRoom) : enough;
    for (const bool firm : {true, false})
      if (const auto spot = towards ? nearSpot(is, firm, room) : spotOf(is, firm);
          spot && spot->depth >= room)
        return placeAt(m_layers[all.layer], all.x(spot->cell), all.y(spot->cell), false);
  }
  const std::optional<SeenPlace> dot = fine().dotPlace(all.layer, before, near);
  if (dot && !dot->hidden)
    return dot;
  const auto ground = spotOf([](Worth one) { return one == Worth::ground; }, false);
  if (ground)
    return placeAt(m_layers[all.layer], all.x(ground->cell), all.y(ground->cell), false);
  return dot;
}

std::optional<model::Annotation> SeenMap::labelFor(model::NodeId structure) const {
  const std::optional<SeenPlace> place = find(structure);
  return place ? std::optional(labelAt(structure, *place)) : std::nullopt;
}

model::Annotation SeenMap::labelAt(model::NodeId structure, const SeenPlace& place) {
  // A cut face has no triangle to point at; the next picture finds the face again.
  const auto* point = std::get_if<model::SurfacePoint>(&place.anchor);
  return {
      .anchors = {point ? *point : model::SurfacePoint{structure, 0, {1.0f / 3.0f, 1.0f / 3.0f}}},
      .found = true};
}

}  // namespace sline::render
