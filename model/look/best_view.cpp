// SPDX-License-Identifier: Apache-2.0
#include "model/look/best_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <unordered_set>
#include <vector>

#include "model/base/parallel.h"
#include "model/focus/tissues.h"
#include "model/scene/visible_structures.h"

namespace sline::model {

namespace {

/// Says along which axis two opposite parallel views look, and which axes are across.
struct Axes {
  glm::length_t across;
  glm::length_t upwards;
  glm::length_t along;
  AnatomicalView fromHigh;  ///< seen from where the coordinate along is high
  AnatomicalView fromLow;
};
constexpr std::array<Axes, 3> allAxes{
    {{2, 0, 1, AnatomicalView::posterior, AnatomicalView::anterior},
     {1, 2, 0, AnatomicalView::left, AnatomicalView::right},
     {0, 1, 2, AnatomicalView::superior, AnatomicalView::inferior}}};

/// Returns the directions to the points of a lattice on a cube's surface, 98 of them.
std::vector<glm::vec3> directionsAllRound() {
  std::vector<glm::vec3> directions;
  constexpr int n = 2;
  for (int x = -n; x <= n; ++x)
    for (int y = -n; y <= n; ++y)
      for (int z = -n; z <= n; ++z)
        if (std::max({std::abs(x), std::abs(y), std::abs(z)}) == n)
          directions.push_back(glm::normalize(glm::vec3(x, y, z)));
  return directions;
}

/// Says of what a cell shows a structure.
enum class Kind : std::uint8_t { other, wanted };

/// Tells whether structures of that tissue hide what is behind them in a plate; others become
/// silhouettes where they are in front.
bool staysFilled(Tissue tissue) {
  return tissue == Tissue::bone || tissue == Tissue::joint || tissue == Tissue::organ;
}

constexpr int side = 160;  ///< cells along the longer side of the scene's box

int roundedDown(float x) {
  const int whole = int(x);
  return float(whole) > x ? whole - 1 : whole;
}

int roundedUp(float x) {
  const int whole = int(x);
  return float(whole) < x ? whole + 1 : whole;
}

/// Returns the nearest whole number to one that is not negative.
int rounded(float x) {
  const int whole = int(x);
  return x - float(whole) >= 0.5f ? whole + 1 : whole;
}

/// The nearest surface in each cell of two opposite parallel views, and of which kind it is.
class DepthMap {
 public:
  DepthMap(const Axes& axes, const Box& box) : m_axes(axes) {
    const glm::vec3 size = box.high - box.low;
    m_low = box.low;
    m_cell = std::max({size.x, size.y, size.z, 1e-6f}) / float(side);
    m_columns = int(size[axes.across] / m_cell) + 1;
    m_rows = int(size[axes.upwards] / m_cell) + 1;
    m_cells.resize(std::size_t(m_columns) * std::size_t(m_rows));
  }

  void add(const Mesh& mesh, Kind kind) {
    std::vector<glm::vec3> places;
    places.reserve(mesh.positions().size());
    for (const glm::vec3& position : mesh.positions())
      places.push_back(placed(position));
    for (const Triangle& t : mesh.triangles())
      add(places[t[0]], places[t[1]], places[t[2]], kind);
  }

  /// Returns the area of the structures of that kind that is seen, mm².
  double seenFromHigh(Kind kind) const { return areaWhere(&Cell::kindFromHigh, kind); }
  double seenFromLow(Kind kind) const { return areaWhere(&Cell::kindFromLow, kind); }

 private:
  struct Cell {
    float highest = -std::numeric_limits<float>::infinity();
    float lowest = std::numeric_limits<float>::infinity();
    Kind kindFromHigh = Kind::other;
    Kind kindFromLow = Kind::other;
  };

  double areaWhere(Kind Cell::*which, Kind kind) const {
    const auto cells = std::count_if(m_cells.begin(), m_cells.end(),
                                     [&](const Cell& cell) { return cell.*which == kind; });
    return double(cells) * double(m_cell) * double(m_cell);
  }

  void add(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, Kind kind) {
    const glm::vec3 low = glm::min(glm::min(a, b), c);
    const glm::vec3 high = glm::max(glm::max(a, b), c);
    const int left = roundedUp(low.x);
    const int right = roundedDown(high.x);
    const int top = roundedUp(low.y);
    const int bottom = roundedDown(high.y);
    const float area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    if (left > right || top > bottom || area == 0.0f)
      return put(rounded(a.x), rounded(a.y), a.z, kind);
    for (int y = top; y <= bottom; ++y)
      for (int x = left; x <= right; ++x) {
        const float px = float(x) - a.x;
        const float py = float(y) - a.y;
        const float s = (px * (c.y - a.y) - py * (c.x - a.x)) / area;
        const float t = ((b.x - a.x) * py - (b.y - a.y) * px) / area;
        if (s >= 0.0f && t >= 0.0f && s + t <= 1.0f)
          put(x, y, a.z + s * (b.z - a.z) + t * (c.z - a.z), kind);
      }
  }

  /// Returns the cell as x and y and the coordinate along the line of sight as z.
  glm::vec3 placed(const glm::vec3& p) const {
    return {(p[m_axes.across] - m_low[m_axes.across]) / m_cell,
            (p[m_axes.upwards] - m_low[m_axes.upwards]) / m_cell, p[m_axes.along]};
  }

  void put(int x, int y, float along, Kind kind) {
    if (x < 0 || y < 0 || x >= m_columns || y >= m_rows)
      return;
    Cell& cell = m_cells[std::size_t(y) * std::size_t(m_columns) + std::size_t(x)];
    if (along > cell.highest) {
      cell.highest = along;
      cell.kindFromHigh = kind;
    }
    if (along < cell.lowest) {
      cell.lowest = along;
      cell.kindFromLow = kind;
    }
  }

  Axes m_axes;
  glm::vec3 m_low{0.0f};
  float m_cell = 1.0f;
  int m_columns = 0;
  int m_rows = 0;
  std::vector<Cell> m_cells;
};

using IdValues = std::unordered_set<std::uint64_t>;

IdValues valuesOf(std::span<const NodeId> structures) {
  IdValues ids;
  for (const NodeId id : structures)
    ids.insert(id.value);
  return ids;
}

Box boundsOf(const std::vector<VisibleStructure>& structures) {
  Box box;
  for (const VisibleStructure& each : structures)
    box.add(each.node->mesh->bounds());
  return box;
}

}  // namespace

AnatomicalView bestViewOf(const Scene& scene, std::span<const NodeId> structures) {
  const IdValues wanted = valuesOf(structures);
  const std::vector<VisibleStructure> visible = visibleStructures(scene);
  const Box box = boundsOf(visible);
  if (box.empty())
    return AnatomicalView::anterior;
  const Tissues tissues = tissuesOf(scene);
  std::array<double, 2 * allAxes.size()> seen{};
  parallelFor(allAxes.size(), 1, [&](std::size_t i) {
    const Axes& axes = allAxes[i];
    DepthMap map(axes, box);
    for (const bool others : {false, true}) {
      for (const VisibleStructure& each : visible) {
        const bool asked = wanted.contains(each.node->id.value);
        if (asked != others && (asked || staysFilled(tissues.at(each.node->id.value))))
          map.add(*each.node->mesh, asked ? Kind::wanted : Kind::other);
      }
      seen[std::size_t(axes.fromHigh)] += map.seenFromHigh(Kind::wanted);
      seen[std::size_t(axes.fromLow)] += map.seenFromLow(Kind::wanted);
    }
  });
  const auto best = std::max_element(seen.begin(), seen.end());
  constexpr double worthTurning = 1.2;
  return *best > worthTurning * seen.front() ? AnatomicalView(best - seen.begin())
                                             : AnatomicalView::anterior;
}

namespace {

/// A place on a structure whose sight counts, and how much.
struct Watched {
  SurfaceSample sample;
  double area = 0.0;
  bool besides = false;
};

std::vector<Watched> watchedOf(const std::vector<FormPtr>& forms, bool besides) {
  constexpr std::size_t stride = 4;
  std::vector<Watched> watched;
  for (const FormPtr& form : forms)
    for (std::size_t i = stride / 2; i < form->samples.size(); i += stride)
      watched.push_back(
          {form->samples[i], form->area / double(form->samples.size()) * double(stride), besides});
  return watched;
}

}  // namespace

glm::vec3 clearestDirection(const Scene& scene, std::span<const NodeId> structures,
                            std::span<const NodeId> besides, FormIndex& forms) {
  const IdValues wanted = valuesOf(structures);
  const IdValues second = valuesOf(besides);
  std::vector<FormPtr> all;
  std::vector<FormPtr> first;
  std::vector<FormPtr> others;
  for (const VisibleStructure& each : visibleStructures(scene)) {
    all.push_back(forms.of(each.node->mesh));
    if (wanted.contains(each.node->id.value))
      first.push_back(all.back());
    else if (second.contains(each.node->id.value))
      others.push_back(all.back());
  }
  std::vector<Watched> watched = watchedOf(first, false);
  const std::vector<Watched> more = watchedOf(others, true);
  watched.insert(watched.end(), more.begin(), more.end());
  const std::vector<glm::vec3> directions = directionsAllRound();
  std::vector<std::array<double, 2>> seen(directions.size(), {0.0, 0.0});
  parallelFor(directions.size(), 1, [&](std::size_t i) {
    const glm::vec3& way = directions[i];
    for (const Watched& each : watched) {
      const float facing = glm::dot(each.sample.normal, way);
      constexpr float clear = 0.02f;  // mm: off the surface that it lies on
      const Ray ray{each.sample.place + clear * each.sample.normal, way};
      if (facing > 0.0f && std::none_of(all.begin(), all.end(), [&ray](const FormPtr& form) {
            return form->tree->blocked(ray);
          }))
        seen[i][each.besides ? 1 : 0] += each.area * double(facing);
    }
  });
  double most = 0.0;
  for (const auto& [main, beside] : seen)
    most = std::max(most, main);
  constexpr double nearly = 0.9;
  std::size_t best = 0;
  for (std::size_t i = 1; i < seen.size(); ++i) {
    const bool clear = seen[i][0] >= nearly * most;
    const bool bestIsClear = seen[best][0] >= nearly * most;
    if (clear && (!bestIsClear || seen[i][1] > seen[best][1]))
      best = i;
  }
  return directions[best];
}

}  // namespace sline::model
