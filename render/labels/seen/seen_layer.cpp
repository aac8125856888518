// SPDX-License-Identifier: Apache-2.0
#include "render/labels/seen/seen_layer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "model/cuts/plane_section.h"
#include "model/geometry/sight.h"
#include "render/drawn/face_patterns.h"
#include "render/drawn/section_caps.h"

namespace sline::render {

namespace {

// Millimetres between surfaces that share a wall, in models whose parts fit each other.
constexpr float touching = 0.05f;

}  // namespace

SeenLayer::SeenLayer(const model::Node& node, const model::ResolvedStyle& style,
                     const SeenLook& look)
    : m_node(&node), m_mesh(node.mesh), m_style(style), m_look(look) {}

SeenLayer::SeenLayer(const model::Scene& scene, const model::Node& node,
                     const model::ResolvedStyle& style, bool onDark)
    : SeenLayer(node, style, SeenLook(style, onDark)) {
  const std::vector<model::Section> sections = scene.sectionsOf(node.id);
  m_planes = model::planesOf(sections);
  for (const model::Section& section : sections)
    m_faces.push_back(section.faces);
}

SeenLayer SeenLayer::undrawn() const {
  SeenLayer layer(*m_node, m_style, m_look);
  layer.m_mesh = m_mesh;
  layer.m_surface = m_surface;
  layer.m_faces = m_faces;
  layer.m_planes = m_planes;
  layer.m_pattern = m_pattern;
  layer.m_patternKnown = m_patternKnown;
  return layer;
}

SeenFill SeenLayer::fillOf(const SeenCell& cell, float bent) const {
  switch (cell.what) {
    case SeenCell::What::surface:
      return m_look.surface(cell.facing, bent);
    case SeenCell::What::cutFace:
      return m_look.cutFace(facesOf(cell), m_pattern);
    default:
      return {};
  }
}

void SeenLayer::project(const Screen& screen, const SeenGrid& grid) {
  const auto positions = m_mesh->positions();
  m_corners.resize(positions.size());
  glm::vec2 low(1e9f);
  glm::vec2 high(-1e9f);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const std::optional<glm::vec2> place = screen.place(positions[i]);
    m_corners[i].seen = place.has_value();
    if (!place)
      continue;
    m_corners[i].cell = (*place - grid.corner) / grid.side;
    m_corners[i].depth = screen.depthKey(positions[i]);
    low = glm::min(low, m_corners[i].cell);
    high = glm::max(high, m_corners[i].cell);
  }
  m_side = grid.side;
  m_perspective = screen.camera().projection == model::Projection::perspective;
  constexpr float around = 4.0f;
  low = glm::clamp(glm::floor(low) - around, glm::vec2(0.0f), glm::vec2(grid.columns, grid.rows));
  high = glm::clamp(glm::ceil(high) + around, glm::vec2(0.0f), glm::vec2(grid.columns, grid.rows));
  m_left = int(low.x);
  m_top = int(low.y);
  m_columns = std::max(int(high.x) - m_left, 0);
  m_rows = std::max(int(high.y) - m_top, 0);
  m_cells.assign(std::size_t(m_columns) * std::size_t(m_rows), SeenCell{});
}

void SeenLayer::take(int x, int y, const SeenCell& cell) {
  SeenCell& known = m_cells[index(x, y)];
  if (known.what == SeenCell::What::nothing || cell.depth < known.depth)
    known = cell;
}

FlatTriangle SeenLayer::flat(const Screen& screen, const model::Triangle& t) const {
  const std::array<const Corner*, 3> c{&m_corners[t[0]], &m_corners[t[1]], &m_corners[t[2]]};
  return {{c[0]->cell, c[1]->cell, c[2]->cell},
          {screen.inverseDepth(c[0]->depth), screen.inverseDepth(c[1]->depth),
           screen.inverseDepth(c[2]->depth)}};
}

void SeenLayer::drawTriangle(const Screen& screen, std::uint32_t triangle) {
  const model::Mesh& mesh = *m_mesh;
  const model::Triangle& t = mesh.triangles()[triangle];
  if (!m_corners[t[0]].seen || !m_corners[t[1]].seen || !m_corners[t[2]].seen)
    return;
  const FlatTriangle seen = flat(screen, t);
  const PixelRect cells = seen.box({m_left, m_top, m_columns, m_rows});
  if (cells.empty())
    return;
  const glm::vec3& a = mesh.positions()[t[0]];
  const glm::vec3& b = mesh.positions()[t[1]];
  const glm::vec3& d = mesh.positions()[t[2]];
  const glm::vec3 depths(m_corners[t[0]].depth, m_corners[t[1]].depth, m_corners[t[2]].depth);
  const glm::vec3 normal = glm::cross(b - a, d - a);
  const float length = glm::length(normal);
  const glm::vec3 towards = model::towardsEye(screen.camera(), a);
  const float facing = length > 0.0f ? glm::dot(normal, towards) / length : 0.0f;
  const float side = facing < 0.0f ? -1.0f : 1.0f;
  const auto facingAt = [&](const glm::vec3& shares) {
    if (!m_surface)
      return facing;
    const auto& n = m_surface->normals;
    const glm::vec3 smooth = shares.x * n[t[0]] + shares.y * n[t[1]] + shares.z * n[t[2]];
    const float across = glm::length(smooth);
    const float shaded = across > 0.0f ? std::abs(glm::dot(smooth, towards)) / across : 0.0f;
    return side * shaded;
  };
  seen.forEachCell(cells, [&](int x, int y, const glm::vec3& shares) {
    if (!m_planes.empty()) {
      const glm::vec3 s = seen.inSpace(shares);
      if (!model::keptByAll(m_planes, s.x * a + s.y * b + s.z * d))
        return;
    }
    take(x, y,
         {.depth = glm::dot(shares, depths),
          .triangle = triangle,
          .facing = facingAt(shares),
          .what = SeenCell::What::surface});
  });
}

void SeenLayer::findCutFaces(const model::Scene& scene, const Screen& screen,
                             const SeenGrid& grid) {
  if (m_planes.empty() || !(m_surface ? m_surface->solid : model::isSolid(*m_mesh)))
    return;
  std::vector<std::optional<float>> steps(m_planes.size());
  for (int y = m_top; y < m_top + m_rows; ++y)
    for (int x = m_left; x < m_left + m_columns; ++x) {
      SeenCell& cell = m_cells[index(x, y)];
      if (cell.what != SeenCell::What::surface || cell.facing >= 0.0f)
        continue;
      // A ray that sees the surface from within has come through the face of a cut.
      const model::Ray ray = screen.sight(grid.middle(x, y));
      const model::KeptSpan kept = model::keptSpan(ray, m_planes);
      if (!kept.entered || kept.empty())
        continue;
      std::optional<float>& step = steps[*kept.entered];
      if (!step)
        step = faceSteps(model::sectionArea(*m_mesh, m_planes[*kept.entered]),
                         scene.visibleBounds().size());
      cell.depth =
          inFront(screen.depthKey(ray.origin + float(kept.nearest) * ray.direction), *step);
      cell.what = SeenCell::What::cutFace;
      cell.face = std::uint8_t(*kept.entered);
      cell.facing = 1.0f;
    }
  const bool cut = std::any_of(steps.begin(), steps.end(), [](const auto& step) { return step; });
  if (cut && !m_patternKnown) {
    m_pattern = cutPattern(scene, *m_node);
    m_patternKnown = true;
  }
}

/// Surfaces that fall between the middles of cells are seen all the same.
void SeenLayer::plotSmall(const Screen& screen) {
  const model::Mesh& mesh = *m_mesh;
  for (std::uint32_t i = 0; i < mesh.triangleCount(); ++i) {
    const model::SurfacePoint middle{m_node->id, i, {1.0f / 3.0f, 1.0f / 3.0f}};
    const glm::vec3 at = model::placeOn(mesh, middle);
    const model::Triangle& t = mesh.triangles()[i];
    if (!m_corners[t[0]].seen || !m_corners[t[1]].seen || !m_corners[t[2]].seen ||
        !model::keptByAll(m_planes, at))
      continue;
    const glm::vec2 cell =
        (m_corners[t[0]].cell + m_corners[t[1]].cell + m_corners[t[2]].cell) / 3.0f;
    const int x = int(std::floor(cell.x));
    const int y = int(std::floor(cell.y));
    if (x >= m_left && y >= m_top && x < m_left + m_columns && y < m_top + m_rows)
      take(x, y,
           {.depth = screen.depthKey(at),
            .triangle = i,
            .facing = 1.0f,
            .what = SeenCell::What::surface});
  }
}

void SeenLayer::findOutlines(float pen) {
  struct Beside {
    std::size_t cell;
    float depth;
    float ink;
  };
  std::vector<Beside> besides;
  // The pen's inner edge lies half a λ within the surface, the rest outside.
  const int reach = pen > 1.5f ? 2 : 1;
  const float inner = reach > 1 ? 0.5f : 1.0f;
  const float outer = std::clamp(pen - 1.0f, 0.0f, 1.0f);
  constexpr std::array<std::array<int, 2>, 4> ways{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
  for (int y = m_top; y < m_top + m_rows; ++y)
    for (int x = m_left; x < m_left + m_columns; ++x) {
      SeenCell& cell = m_cells[index(x, y)];
      const bool here = covers(x, y);
      for (const auto& [dx, dy] : ways) {
        const SeenCell& other = at(x + dx, y + dy);
        const bool there = covers(x + dx, y + dy);
        if (here) {
          cell.outline = cell.outline || !there || other.depth - cell.depth > m_fold;
        } else if (there) {
          besides.push_back({index(x, y), other.depth, 1.0f});
        } else if (reach > 1 && covers(x + 2 * dx, y + 2 * dy)) {
          besides.push_back({index(x, y), at(x + 2 * dx, y + 2 * dy).depth, outer});
        }
      }
      cell.ink = cell.outline ? inner : 0.0f;
      cell.facing = std::abs(cell.facing);
    }
  // Ink lies outside the surface.
  for (const Beside& one : besides) {
    SeenCell& cell = m_cells[one.cell];
    if (cell.what == SeenCell::What::nothing || one.ink > cell.ink ||
        (one.ink == cell.ink && one.depth < cell.depth))
      cell = {.depth = one.depth,
              .triangle = 0,
              .facing = 0.0f,
              .what = SeenCell::What::beside,
              .outline = true,
              .ink = one.ink};
  }
}

void SeenLayer::draw(const model::Scene& scene, const Screen& screen, const SeenGrid& grid) {
  const model::Mesh& mesh = *m_mesh;
  m_remains = std::any_of(mesh.positions().begin(), mesh.positions().end(),
                          [this](const glm::vec3& p) { return model::keptByAll(m_planes, p); });
  project(screen, grid);
  if (m_cells.empty() || !m_remains)
    return;
  for (std::uint32_t i = 0; i < mesh.triangleCount(); ++i)
    drawTriangle(screen, i);
  const auto drawn = std::count_if(m_cells.begin(), m_cells.end(), [](const SeenCell& cell) {
    return cell.what == SeenCell::What::surface;
  });
  constexpr int few = 12;
  if (drawn < few)
    plotSmall(screen);
  const glm::vec3 middle = mesh.bounds().centre();
  const float fold = 0.04f * glm::length(mesh.bounds().size());
  const glm::vec3 back = model::cameraFrame(screen.camera()).back;
  const auto step = [&](float mm) {
    return std::abs(screen.depthKey(middle - mm * back) - screen.depthKey(middle));
  };
  m_fold = step(fold);
  m_touch = step(touching);
  findCutFaces(scene, screen, grid);
  const float lambda = screen.size().y / 720.0f;
  findOutlines(m_look.pen() * lambda / grid.side);
}

SeenLayer::Spot SeenLayer::spotAt(const Screen& screen, const SeenGrid& grid, int x, int y) const {
  const SeenCell& cell = at(x, y);
  const glm::vec2 place = grid.middle(x, y);
  const model::Ray ray = screen.sight(place);
  if (cell.what == SeenCell::What::cutFace) {
    const model::KeptSpan kept = model::keptSpan(ray, m_planes);
    return {ray.origin + float(kept.nearest) * ray.direction, place};
  }
  const FlatTriangle seen = flat(screen, m_mesh->triangles()[cell.triangle]);
  const glm::vec3 shares = seen.sharesAt(glm::vec2(x, y) + 0.5f);
  model::SurfacePoint point{m_node->id, cell.triangle, {1.0f / 3.0f, 1.0f / 3.0f}};
  if (!FlatTriangle::holds(shares))
    return {point, screen.place(model::placeOn(*m_mesh, point)).value_or(place)};
  const glm::vec3 s = glm::max(seen.inSpace(shares), 0.0f);
  const float most = std::max(s.y + s.z, 1.0f);
  point.weights = {s.y / most, s.z / most};
  return {point, place};
}

std::optional<glm::vec2> SeenLayer::outwards(int x, int y) const {
  glm::vec2 out(0.0f);
  for (int dy = -3; dy <= 3; ++dy)
    for (int dx = -3; dx <= 3; ++dx)
      if (!covers(x + dx, y + dy))
        out += glm::vec2(dx, dy);
  if (glm::length(out) < 1.0f)
    return std::nullopt;
  out = glm::normalize(out);
  const auto step = [&](float far) {
    return std::pair(x + int(std::lround(far * out.x)), y + int(std::lround(far * out.y)));
  };
  for (int far = 2; far <= 5; ++far) {
    const auto [inX, inY] = step(-float(far));
    const auto [outX, outY] = step(float(far));
    if (!covers(inX, inY) || at(inX, inY).outline || (far <= 4 && covers(outX, outY)))
      return std::nullopt;
  }
  return out;
}

std::optional<glm::ivec2> SeenLayer::coveredNear(int x, int y, int far) const {
  std::optional<glm::ivec2> nearest;
  int distance2 = far * far + 1;
  for (int dy = -far; dy <= far; ++dy)
    for (int dx = -far; dx <= far; ++dx)
      if (dx * dx + dy * dy < distance2 && covers(x + dx, y + dy)) {
        nearest = glm::ivec2(x + dx, y + dy);
        distance2 = dx * dx + dy * dy;
      }
  return nearest;
}

}  // namespace sline::render
