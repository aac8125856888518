// SPDX-License-Identifier: Apache-2.0
#include "render/labels/obstacles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "model/geometry/plane.h"
#include "model/scene/resolved_styles.h"

namespace sline::render {

namespace {

constexpr int cellsAcross = 96;
/// The triangles of all structures together, the same number for each.
constexpr std::size_t mostTriangles = 60000;

class Marker {
 public:
  Marker(const Screen& screen, ObstacleMask& mask) : m_screen(screen), m_mask(mask) {}

  void mark(const std::array<glm::vec3, 3>& corners, std::span<const model::Plane> planes) {
    std::array<std::optional<glm::vec2>, 3> places;
    for (std::size_t i = 0; i < 3; ++i)
      places[i] = m_screen.place(corners[i]);
    const float cell = m_mask.size.x / float(m_mask.columns);
    int steps = 1;
    if (places[0] && places[1] && places[2]) {
      const float longest =
          std::max({glm::length(*places[1] - *places[0]), glm::length(*places[2] - *places[1]),
                    glm::length(*places[0] - *places[2])});
      steps = int(std::clamp(std::ceil(longest / cell), 1.0f, float(2 * cellsAcross)));
    }
    for (int i = 0; i <= steps; ++i)
      for (int j = 0; i + j <= steps; ++j) {
        const float u = float(i) / float(steps);
        const float v = float(j) / float(steps);
        const glm::vec3 p = (1.0f - u - v) * corners[0] + u * corners[1] + v * corners[2];
        if (model::keptByAll(planes, p))
          mark(m_screen.place(p));
      }
  }

 private:
  void mark(const std::optional<glm::vec2>& place) {
    if (!place || !m_screen.inside(*place))
      return;
    const glm::vec2 cell = *place / m_mask.size * glm::vec2(m_mask.columns, m_mask.rows);
    const int x = std::min(int(cell.x), m_mask.columns - 1);
    const int y = std::min(int(cell.y), m_mask.rows - 1);
    m_mask.taken[m_mask.cellAt(x, y)] = 1;
    if (!m_mask.extent)
      m_mask.extent = LabelBox{*place, *place};
    m_mask.extent->low = glm::min(m_mask.extent->low, *place);
    m_mask.extent->high = glm::max(m_mask.extent->high, *place);
  }

  const Screen& m_screen;
  ObstacleMask& m_mask;
};

}  // namespace

float ObstacleMask::share(const LabelBox& box) const {
  if (columns == 0 || rows == 0)
    return 0.0f;
  const glm::vec2 scale = glm::vec2(columns, rows) / size;
  const glm::vec2 low = glm::clamp(box.low * scale, glm::vec2(0.0f), glm::vec2(columns, rows));
  const glm::vec2 high = glm::clamp(box.high * scale, glm::vec2(0.0f), glm::vec2(columns, rows));
  float covered = 0.0f;
  for (int y = int(low.y); y < std::min(int(std::ceil(high.y)), rows); ++y)
    for (int x = int(low.x); x < std::min(int(std::ceil(high.x)), columns); ++x)
      if (taken[cellAt(x, y)])
        covered += (std::min(high.x, float(x + 1)) - std::max(low.x, float(x))) *
                   (std::min(high.y, float(y + 1)) - std::max(low.y, float(y)));
  const glm::vec2 all = box.size() * scale;
  return all.x * all.y > 0.0f ? covered / (all.x * all.y) : 0.0f;
}

ObstacleMask obstaclesOf(const model::Scene& scene, const Screen& screen) {
  ObstacleMask mask{.columns = cellsAcross,
                    .rows = std::clamp(
                        int(std::lround(cellsAcross * screen.size().y / screen.size().x)), 8, 1024),
                    .size = screen.size()};
  mask.taken.assign(std::size_t(mask.columns) * std::size_t(mask.rows), 0);
  Marker marker(screen, mask);
  const std::array<model::NodeId, 1> all{model::rootId};
  std::vector<model::ResolvedStructure> structures = model::resolvedBelow(scene, all);
  std::erase_if(structures, [](const model::ResolvedStructure& structure) {
    return !structure.style.visible || structure.style.opacity.value() <= 0.0f;
  });
  for (const model::ResolvedStructure& structure : structures) {
    const model::Mesh& mesh = *structure.node->mesh;
    const std::vector<model::Plane> planes = model::planesOf(scene.sectionsOf(structure.node->id));
    const std::size_t stride = 1 + mesh.triangleCount() * structures.size() / mostTriangles;
    for (std::size_t i = 0; i < mesh.triangleCount(); i += stride) {
      const auto& [a, b, c] = mesh.triangles()[i];
      marker.mark({mesh.positions()[a], mesh.positions()[b], mesh.positions()[c]}, planes);
    }
  }
  return mask;
}

}  // namespace sline::render
