// SPDX-License-Identifier: Apache-2.0
#include "model/look/best_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <unordered_set>
#include <vector>

#include "model/base/parallel.h"
#include "model/focus/tissues.h"
#include "model/scene/visible_structures.h"

namespace sline::model {

namespace {

/// Says which way an anatomical view looks: along that axis of LPS, the eye at the end named.
struct Direction {
  int axis;
  float sign;  ///< the eye lies at +sign along the axis
};
constexpr std::array<Direction, 6> directions{{{1, -1.0f},  // anterior: −y is the front
                                               {1, 1.0f},
                                               {0, 1.0f},  // left: +x
                                               {0, -1.0f},
                                               {2, 1.0f},  // superior: +z
                                               {2, -1.0f}}};

/// Tells whether structures of that tissue hide what is behind them in a plate; others become
/// silhouettes where they are in front.
bool staysFilled(Tissue tissue) {
  return tissue == Tissue::bone || tissue == Tissue::joint || tissue == Tissue::organ;
}

constexpr int side = 160;  ///< cells along the longer side of the scene's box

/// The nearest surface in each cell of a parallel view along an axis.
class DepthMap {
 public:
  DepthMap(const Direction& direction, const Box& box)
      : m_direction(direction), m_u((direction.axis + 1) % 3), m_v((direction.axis + 2) % 3) {
    const glm::vec3 size = box.high - box.low;
    m_low = box.low;
    m_cell = std::max({size.x, size.y, size.z, 1e-6f}) / float(side);
    m_columns = int(size[m_u] / m_cell) + 1;
    m_rows = int(size[m_v] / m_cell) + 1;
    m_depth.assign(std::size_t(m_columns) * std::size_t(m_rows),
                   -std::numeric_limits<float>::infinity());
    m_wanted.assign(m_depth.size(), 0);
  }

  void add(const Mesh& mesh, bool wanted) {
    const auto positions = mesh.positions();
    for (const Triangle& t : mesh.triangles())
      add({positions[t[0]], positions[t[1]], positions[t[2]]}, wanted);
  }

  /// Returns the area of the wanted structures that is seen, mm².
  double seen() const {
    const auto cells = std::count(m_wanted.begin(), m_wanted.end(), 1);
    return double(cells) * double(m_cell) * double(m_cell);
  }

 private:
  void add(const std::array<glm::vec3, 3>& corners, bool wanted) {
    glm::vec3 a = placed(corners[0]);
    glm::vec3 b = placed(corners[1]);
    glm::vec3 c = placed(corners[2]);
    const glm::vec3 low = glm::min(glm::min(a, b), c);
    const glm::vec3 high = glm::max(glm::max(a, b), c);
    const int left = int(std::ceil(low.x));
    const int right = int(std::floor(high.x));
    const int top = int(std::ceil(low.y));
    const int bottom = int(std::floor(high.y));
    const float area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    if (left > right || top > bottom || area == 0.0f)
      return put(int(std::lround(a.x)), int(std::lround(a.y)), a.z, wanted);
    for (int y = top; y <= bottom; ++y)
      for (int x = left; x <= right; ++x) {
        const float px = float(x) - a.x;
        const float py = float(y) - a.y;
        const float s = (px * (c.y - a.y) - py * (c.x - a.x)) / area;
        const float t = ((b.x - a.x) * py - (b.y - a.y) * px) / area;
        if (s >= 0.0f && t >= 0.0f && s + t <= 1.0f)
          put(x, y, a.z + s * (b.z - a.z) + t * (c.z - a.z), wanted);
      }
  }

  /// Returns the cell as x and y and how near to the eye the point is as z.
  glm::vec3 placed(const glm::vec3& p) const {
    return {(p[m_u] - m_low[m_u]) / m_cell, (p[m_v] - m_low[m_v]) / m_cell,
            m_direction.sign * p[m_direction.axis]};
  }

  void put(int x, int y, float depth, bool wanted) {
    if (x < 0 || y < 0 || x >= m_columns || y >= m_rows)
      return;
    const std::size_t cell = std::size_t(y) * std::size_t(m_columns) + std::size_t(x);
    if (!(depth > m_depth[cell]))
      return;
    m_depth[cell] = depth;
    m_wanted[cell] = wanted ? 1 : 0;
  }

  Direction m_direction;
  int m_u;
  int m_v;
  glm::vec3 m_low{0.0f};
  float m_cell = 1.0f;
  int m_columns = 0;
  int m_rows = 0;
  std::vector<float> m_depth;
  std::vector<std::uint8_t> m_wanted;
};

}  // namespace

AnatomicalView bestViewOf(const Scene& scene, std::span<const NodeId> structures) {
  std::unordered_set<std::uint64_t> wanted;
  for (const NodeId id : structures)
    wanted.insert(id.value);
  const std::vector<VisibleStructure> visible = visibleStructures(scene);
  Box box;
  for (const VisibleStructure& each : visible)
    box.add(each.node->mesh->bounds());
  if (box.empty())
    return AnatomicalView::anterior;
  const Tissues tissues = tissuesOf(scene);
  std::array<double, directions.size()> seen{};
  parallelFor(directions.size(), 1, [&](std::size_t i) {
    DepthMap map(directions[i], box);
    for (const bool others : {false, true}) {
      for (const VisibleStructure& each : visible) {
        const bool asked = wanted.contains(each.node->id.value);
        if (asked != others && (asked || staysFilled(tissues.at(each.node->id.value))))
          map.add(*each.node->mesh, asked);
      }
      seen[i] += map.seen();
    }
  });
  const auto best = std::max_element(seen.begin(), seen.end());
  constexpr double worthTurning = 1.2;
  return *best > worthTurning * seen.front() ? AnatomicalView(best - seen.begin())
                                             : AnatomicalView::anterior;
}

}  // namespace sline::model
