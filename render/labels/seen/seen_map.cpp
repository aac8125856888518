// SPDX-License-Identifier: Apache-2.0
#include "render/labels/seen/seen_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <span>

#include "model/base/parallel.h"
#include "model/scene/resolved_styles.h"
#include "model/scene/visible_structures.h"

namespace sline::render {

namespace {

/// Cells along the picture's height: two units of output each, as wide as the usual pen.
constexpr int cellsHigh = 360;
/// Of the structures that share one surface, and so lie in one place, so many are drawn, and those
/// that have labels. A scene may have thousands, of which pictures show one or a few.
constexpr int mostOfOneSurface = 16;

}  // namespace

SeenMap::SeenMap(const model::Scene& scene, const Screen& screen, model::MeshTrees* meshes)
    : m_scene(scene), m_screen(screen), m_meshes(meshes) {
  m_grid.side = screen.size().y / float(cellsHigh);
  m_grid.rows = cellsHigh;
  m_grid.columns = std::clamp(int(std::ceil(screen.size().x / m_grid.side)), 1, 8 * cellsHigh);
  const std::array<model::NodeId, 1> all{model::rootId};
  const std::unordered_set<std::uint64_t> labelled = model::annotatedStructures(scene);
  std::map<const model::Mesh*, int> drawn;
  for (const model::ResolvedStructure& one : model::resolvedBelow(scene, all))
    if (one.style.visible && one.style.opacity.value() > 0.0f) {
      if (++drawn[one.node->mesh.get()] > mostOfOneSurface &&
          !labelled.contains(one.node->id.value))
        continue;
      m_index[one.node->id] = std::uint32_t(m_layers.size());
      m_layers.emplace_back(scene, *one.node, one.style, screen.dark());
    }
  parallelFor(m_layers.size(), 1,
              [&](std::size_t i) { m_layers[i].draw(m_scene, m_screen, m_grid); });
  compose();
}

SeenMap::SeenMap(const SeenMap& other, const SeenGrid& grid)
    : m_scene(other.m_scene),
      m_screen(other.m_screen),
      m_grid(grid),
      m_index(other.m_index),
      m_meshes(other.m_meshes) {
  for (const SeenLayer& layer : other.m_layers)
    m_layers.push_back(layer.undrawn());
  takeSurfaces();
  parallelFor(m_layers.size(), 1,
              [&](std::size_t i) { m_layers[i].drawAsInPictures(m_scene, m_screen, m_grid); });
  compose();
}

void SeenMap::takeSurfaces() {
  model::MeshTrees& surfaces = m_meshes ? *m_meshes : m_own;
  std::map<model::MeshPtr, const SeenLayer*> missing;
  for (const SeenLayer& layer : m_layers)
    if (!surfaces.surfaceOf(layer.node().mesh))
      missing.emplace(layer.node().mesh, &layer);
  std::vector<std::pair<const SeenLayer*, model::SurfacePtr>> made;
  made.reserve(missing.size());
  for (const auto& [mesh, layer] : missing)
    made.emplace_back(layer, nullptr);
  parallelFor(made.size(), 1, [&](std::size_t i) { made[i].second = made[i].first->pictured(); });
  for (const auto& [layer, surface] : made)
    surfaces.surfaceOf(layer->node().mesh) = surface;
  for (SeenLayer& layer : m_layers)
    layer.takeSurface(surfaces.surfaceOf(layer.node().mesh));
}

const SeenMap& SeenMap::fine() const {
  if (!m_fine) {
    SeenGrid grid = m_grid;
    grid.side *= 0.5f;
    grid.columns *= 2;
    grid.rows *= 2;
    m_fine.reset(new SeenMap(*this, grid));
  }
  return *m_fine;
}

const SeenLayer* SeenMap::layerOf(model::NodeId id) const {
  const auto found = m_index.find(id);
  return found == m_index.end() ? nullptr : &m_layers[found->second];
}

bool SeenMap::draws(model::NodeId structure) const {
  const SeenLayer* layer = layerOf(structure);
  return layer && layer->remains();
}

std::span<const SeenMap::Fragment> SeenMap::fragments(int x, int y) const {
  if (x < 0 || y < 0 || x >= m_grid.columns || y >= m_grid.rows)
    return {};
  const std::size_t cell = std::size_t(y) * std::size_t(m_grid.columns) + std::size_t(x);
  return std::span(m_fragments).subspan(m_first[cell], m_first[cell + 1] - m_first[cell]);
}

void SeenMap::cover() {
  for (const LabelBox& box : m_screen.covered()) {
    const auto cell = [this](float mm, int most) {
      return std::clamp(int(std::floor(mm / m_grid.side)), 0, most - 1);
    };
    const LabelBox seen{glm::max(box.low, glm::vec2(0.0f)), glm::min(box.high, m_screen.size())};
    if (seen.low.x >= seen.high.x || seen.low.y >= seen.high.y)
      continue;
    m_covered.resize(std::size_t(m_grid.columns) * std::size_t(m_grid.rows));
    for (int y = cell(seen.low.y, m_grid.rows); y <= cell(seen.high.y, m_grid.rows); ++y)
      for (int x = cell(seen.low.x, m_grid.columns); x <= cell(seen.high.x, m_grid.columns); ++x)
        m_covered[std::size_t(y) * std::size_t(m_grid.columns) + std::size_t(x)] = true;
  }
}

void SeenMap::compose() {
  cover();
  const std::size_t cells = std::size_t(m_grid.columns) * std::size_t(m_grid.rows);
  m_first.assign(cells + 1, 0);
  const auto forEach = [this](const auto& body) {
    for (std::uint32_t i = 0; i < m_layers.size(); ++i)
      for (int y = m_layers[i].top(); y < m_layers[i].top() + m_layers[i].rows(); ++y)
        for (int x = m_layers[i].left(); x < m_layers[i].left() + m_layers[i].columns(); ++x)
          if (const SeenCell& cell = m_layers[i].at(x, y); cell.what != SeenCell::What::nothing)
            body(i, cell, std::size_t(y) * std::size_t(m_grid.columns) + std::size_t(x));
  };
  forEach([this](std::uint32_t, const SeenCell&, std::size_t at) { ++m_first[at + 1]; });
  for (std::size_t i = 1; i <= cells; ++i)
    m_first[i] += m_first[i - 1];
  m_fragments.resize(m_first[cells]);
  std::vector<std::uint32_t> next(m_first.begin(), m_first.end() - 1);
  forEach([&](std::uint32_t layer, const SeenCell& cell, std::size_t at) {
    const SeenFill fill = m_layers[layer].fillOf(cell);
    const SeenLook& look = m_layers[layer].look();
    m_fragments[next[at]++] = {
        .layer = layer,
        .depth = cell.depth,
        .reach = fill.cover,
        .colour = fill.colour,
        .ink = cell.ink * look.outline(),
        .strokes = cell.what == SeenCell::What::surface ? look.strokes() : 0.0f};
  });
  for (std::size_t i = 0; i < cells; ++i) {
    const auto begin = m_fragments.begin() + m_first[i];
    const auto end = m_fragments.begin() + m_first[i + 1];
    std::sort(begin, end, [](const Fragment& a, const Fragment& b) {
      return a.depth != b.depth ? a.depth < b.depth : a.layer < b.layer;
    });
    float left = 1.0f;
    for (auto one = begin; one != end; ++one) {
      const float cover = one->reach;
      one->reach = left;
      one->colour *= left;
      one->ink *= left;
      one->strokes *= left;
      left *= 1.0f - cover;
    }
  }
}

SeenMap::Worth SeenMap::worthOf(std::uint32_t layer, int x, int y) const {
  const SeenLayer& own = m_layers[layer];
  if (!own.covers(x, y))
    return Worth::none;
  if (covered(x, y))
    return Worth::hidden;
  constexpr float faint = 0.05f;
  constexpr float visible = 0.35f;
  constexpr float clearly = 0.12f;
  constexpr float ahead = 1.4f;
  const SeenCell& cell = own.at(x, y);
  Fragment mine;
  for (const Fragment& one : fragments(x, y))
    if (one.layer == layer)
      mine = one;
  float others = 0.0f;     // the most that another shows around
  float before = 0.0f;     // the most colour that lies over it here
  float beside = 0.0f;     // the most that another shows here
  float inkAround = 0.0f;  // of others' outlines
  bool alone = true;       // nothing else is there, seen or not
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx)
      for (const Fragment& one : fragments(x + dx, y + dy)) {
        if (one.layer == layer)
          continue;
        others = std::max(others, one.most());
        const SeenCell& there = cellOf(one, x + dx, y + dy);
        const bool touching = own.touches(cell, there);
        if (touching)
          others = std::max(others, mine.reach * m_layers[one.layer].fillOf(there).colour);
        inkAround = std::max(inkAround, one.ink);
        alone = alone && one.reach < faint && !touching;
        if (dx != 0 || dy != 0)
          continue;
        beside = std::max(beside, one.most());
        if (one.depth < mine.depth)
          before = std::max(before, one.colour);
      }
  const bool filled = mine.colour >= clearly;
  if (mine.reach >= visible && alone && !own.isPaper(cell))
    return Worth::alone;
  if (filled && mine.colour >= ahead * others)
    return Worth::most;
  const float ink = mine.ink;
  if (ink >= visible && inkAround < 0.5f * ink && before < 0.7f * ink && own.outwards(x, y))
    return Worth::outline;
  if (mine.reach >= visible && others < faint)
    return Worth::ground;
  return filled && mine.colour > beside ? Worth::slim : Worth::hidden;
}

bool SeenMap::hides(model::NodeId structure, const glm::vec3& p) const {
  const SeenLayer* layer = layerOf(structure);
  const std::optional<glm::vec2> place = m_screen.place(p);
  if (!layer || !place)
    return true;
  const int x = int(std::floor(place->x / m_grid.side));
  const int y = int(std::floor(place->y / m_grid.side));
  // A place at the very edge may lie in a cell whose middle is beside the surface.
  std::optional<std::pair<int, int>> near;
  for (const auto& [dx, dy] :
       {std::pair(0, 0), std::pair(-1, 0), std::pair(1, 0), std::pair(0, -1), std::pair(0, 1)})
    if (!near && layer->covers(x + dx, y + dy))
      near = {x + dx, y + dy};
  if (!near)
    return true;
  const std::uint32_t index = m_index.at(structure);
  const SeenCell& cell = layer->at(near->first, near->second);
  // Its own nearer parts hide it, too, if they are nearer by more than 1/200 of its size.
  const float size = glm::length(layer->node().mesh->bounds().size());
  const model::Ray ray = m_screen.sight(*place);
  const float slack = 0.005f * size;
  const glm::vec3 nearer = p - slack * ray.direction;
  const bool behind = m_screen.place(nearer) && !cell.outline &&
                      cell.depth < m_screen.depthKey(nearer) - 0.5f * m_grid.side * 1e-6f &&
                      layer->fillOf(cell).cover > 0.5f;
  return behind || worthOf(index, near->first, near->second) <= Worth::hidden;
}

bool SeenMap::showsDot(model::NodeId structure, const glm::vec3& p) const {
  constexpr float radius = 0.45f;  // of a dot, millimetres
  constexpr int steps = 2;
  constexpr float enough = 0.4f;
  if (hides(structure, p))
    return false;
  const std::uint32_t index = m_index.at(structure);
  const glm::vec2 place = *m_screen.place(p);
  int own = 0;
  int all = 0;
  for (int y = -steps; y <= steps; ++y)
    for (int x = -steps; x <= steps; ++x) {
      if (x * x + y * y > steps * steps)
        continue;
      const glm::vec2 at =
          (place + radius / float(steps) * glm::vec2(x, y) - m_grid.corner) / m_grid.side;
      ++all;
      own += worthOf(index, int(std::floor(at.x)), int(std::floor(at.y))) > Worth::hidden ? 1 : 0;
    }
  return float(own) >= enough * float(all);
}

}  // namespace sline::render
