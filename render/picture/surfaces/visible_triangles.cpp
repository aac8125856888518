// SPDX-License-Identifier: Apache-2.0
#include "render/picture/surfaces/visible_triangles.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "model/base/parallel.h"
#include "render/software/seen_cluster.h"
#include "render/strokes/coverage.h"

namespace sline::render {

namespace {

using model::Clusters;

/// The most middles of pixels that are looked at one by one.
constexpr int mostMiddles = 4;

/// Appends the triangles of clusters.
class TriangleFinder {
 public:
  TriangleFinder(const DrawnStructure& shown, const PictureView& view, const SampleGrid& grid)
      : m_shown(shown), m_view(view), m_grid(grid), m_cull(cullsBack(shown, view)) {}

  /// Has the memory fetch the positions of a cluster that will be looked at soon.
  void fetch(const model::Cluster& cluster) const {
    const model::Surface& surface = m_shown.surface();
    const glm::vec3* positions = surface.mesh->positions().data();
    const std::uint32_t* vertices = surface.clusters.vertices.data() + cluster.firstVertex;
    for (std::uint32_t i = 0; i < cluster.vertexCount; ++i)
      __builtin_prefetch(positions + vertices[i]);
  }

  void append(const model::Cluster& cluster, std::vector<std::uint32_t>& visible) {
    const Clusters& clusters = m_shown.surface().clusters;
    const auto* triangles = clusters.localTriangles.data() + cluster.firstTriangle;
    const bool mixed = m_cull && model::facing(cluster, m_view.eye()) != model::Facing::front;
    const bool known =
        m_seen.project(cluster, {clusters, m_shown.surface().mesh->positions()}, m_view, m_grid);
    if (known) {
      m_seen.findBoxes({triangles, cluster.triangleCount});
      m_seen.findSlopes(cluster.triangleCount, SeenCluster::Corners::rounded);
    }
    std::array<std::uint32_t, 3 * std::size_t(Clusters::maximumTriangles)> kept;
    auto end = kept.begin();
    for (std::uint32_t i = 0; i < cluster.triangleCount; ++i) {
      if (known ? (mixed && !(m_seen.area[i] > 0.0f)) || !covers(i)
                : mixed && !facesEye(cluster, triangles[i]))
        continue;
      for (const std::uint8_t corner : triangles[i])
        *end++ = cluster.firstVertex + corner;
    }
    visible.insert(visible.end(), kept.begin(), end);
  }

 private:
  bool covers(std::size_t i) const {
    const int columns = m_seen.columns[i];
    const int rows = m_seen.rows[i];
    if (columns <= 0 || rows <= 0)
      return false;
    return columns > mostMiddles || columns * rows > mostMiddles || holdsMiddle(i);
  }

  /// Tells whether the triangle may hold one of the middles in its box.
  bool holdsMiddle(std::size_t i) const {
    for (int row = 0; row < m_seen.rows[i]; ++row)
      for (int column = 0; column < m_seen.columns[i]; ++column)
        if (m_seen.holds(i, column, row))
          return true;
    return false;
  }

  bool facesEye(const model::Cluster& cluster, const std::array<std::uint8_t, 3>& corners) const {
    const model::Surface& surface = m_shown.surface();
    const auto at = [&](std::uint8_t corner) {
      return surface.mesh->positions()[surface.clusters.vertices[cluster.firstVertex + corner]];
    };
    const glm::vec3 p = at(corners[0]);
    const model::EyePoint& eye = m_view.eye();
    return glm::dot(glm::cross(at(corners[1]) - p, at(corners[2]) - p),
                    eye.atInfinity ? eye.value : eye.value - p) > 0.0f;
  }

  const DrawnStructure& m_shown;
  const PictureView& m_view;
  const SampleGrid& m_grid;
  bool m_cull;
  SeenCluster m_seen;
};

}  // namespace

std::vector<std::uint32_t> visibleTriangles(const DrawnStructure& shown, const PictureView& view,
                                            const TileMask& squares, const SampleGrid& grid) {
  const bool cull = cullsBack(shown, view);
  std::vector<const model::Cluster*> clusters;
  for (const model::Cluster& cluster : shown.surface().clusters.items)
    if ((!cull || model::facing(cluster, view.eye()) != model::Facing::back) &&
        squares.marksAny(view.bounds(cluster.bounds)) && !isCutAway(shown, cluster.bounds))
      clusters.push_back(&cluster);
  constexpr std::size_t piece = 128;
  std::vector<std::vector<std::uint32_t>> found((clusters.size() + piece - 1) / piece);
  parallelFor(found.size(), 1, [&](std::size_t i) {
    TriangleFinder finder(shown, view, grid);
    const std::size_t end = std::min(clusters.size(), (i + 1) * piece);
    for (std::size_t k = i * piece; k < end; ++k) {
      if (k + 1 < end)
        finder.fetch(*clusters[k + 1]);
      finder.append(*clusters[k], found[i]);
    }
  });
  if (found.size() == 1)
    return std::move(found.front());
  std::size_t count = 0;
  for (const std::vector<std::uint32_t>& part : found)
    count += part.size();
  std::vector<std::uint32_t> visible;
  visible.reserve(count);
  for (const std::vector<std::uint32_t>& part : found)
    visible.insert(visible.end(), part.begin(), part.end());
  return visible;
}

}  // namespace sline::render
