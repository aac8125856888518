// SPDX-License-Identifier: Apache-2.0
#include "render/picture/visible_triangles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "model/base/parallel.h"
#include "render/strokes/coverage.h"

namespace sline::render {

namespace {

using model::Clusters;

/// By how much a driver's vertices may lie beside ours, in pixels: it rounds them to 1/256.
constexpr float slack = 1.0f / 256.0f;
/// Farther from the picture's corner floats do not resolve the slack.
constexpr float farthest = 8192.0f;
/// The most middles of pixels that are looked at one by one.
constexpr int mostMiddles = 4;

/// Holds a cluster's vertices as they lie in the picture, counted in steps of the grid, which are
/// pixels below, and its triangles' boxes.
struct SeenCluster {
  std::array<std::array<float, Clusters::maximumVertices>, 3> position;
  std::array<float, Clusters::maximumVertices> x;
  std::array<float, Clusters::maximumVertices> y;
  std::array<std::array<float, Clusters::maximumTriangles>, 3> cornerX;
  std::array<std::array<float, Clusters::maximumTriangles>, 3> cornerY;
  std::array<float, Clusters::maximumTriangles> area;  ///< doubled; positive: turned to the eye
  /// The first middle of a pixel in each triangle's box and how many there are.
  std::array<std::int32_t, Clusters::maximumTriangles> left;
  std::array<std::int32_t, Clusters::maximumTriangles> bottom;
  std::array<std::int32_t, Clusters::maximumTriangles> columns;
  std::array<std::int32_t, Clusters::maximumTriangles> rows;
};

/// Rounds down; `x` lies within ±`farthest`.
std::int32_t below(float x) {
  const auto whole = std::int32_t(x);
  return whole - std::int32_t(float(whole) > x);
}

/// Projects the vertices. Returns false where some lie behind the eye or too far away to tell.
bool project(const model::Cluster& cluster, const DrawnStructure& shown, const PictureView& view,
             const SampleGrid& grid, SeenCluster& seen) {
  const glm::mat4& m = view.viewProjection();
  const glm::vec2 half = 0.5f * view.size();
  const model::Surface& surface = shown.surface();
  const glm::vec2 corner(grid.corner);
  const float perPixel = 1.0f / float(grid.step);
  const std::uint32_t* vertices = surface.clusters.vertices.data() + cluster.firstVertex;
  const auto positions = surface.mesh->positions();
  for (std::uint32_t i = 0; i < cluster.vertexCount; ++i)
    for (int axis = 0; axis < 3; ++axis)
      seen.position[std::size_t(axis)][i] = positions[vertices[i]][axis];
  const auto& [px, py, pz] = seen.position;
  constexpr float nearest = 1e-6f;
  std::int32_t lost = 0;
  for (std::uint32_t i = 0; i < cluster.vertexCount; ++i) {
    const float w = m[0][3] * px[i] + m[1][3] * py[i] + m[2][3] * pz[i] + m[3][3];
    const float x = m[0][0] * px[i] + m[1][0] * py[i] + m[2][0] * pz[i] + m[3][0];
    const float y = m[0][1] * px[i] + m[1][1] * py[i] + m[2][1] * pz[i] + m[3][1];
    seen.x[i] = (x / w + 1.0f) * half.x;
    seen.y[i] = (y / w + 1.0f) * half.y;
    lost |= std::int32_t(!(w > nearest)) | std::int32_t(!(std::abs(seen.x[i]) < farthest)) |
            std::int32_t(!(std::abs(seen.y[i]) < farthest));
    seen.x[i] = (seen.x[i] - corner.x) * perPixel;
    seen.y[i] = (seen.y[i] - corner.y) * perPixel;
  }
  return lost == 0;
}

/// Finds the triangles' areas and which middles of pixels their boxes hold.
void findBoxes(std::size_t count, const std::array<std::uint8_t, 3>* triangles, SeenCluster& seen) {
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t i = 0; i < count; ++i) {
      seen.cornerX[c][i] = seen.x[triangles[i][c]];
      seen.cornerY[c][i] = seen.y[triangles[i][c]];
    }
  const auto& [ax, bx, cx] = seen.cornerX;
  const auto& [ay, by, cy] = seen.cornerY;
  for (std::size_t i = 0; i < count; ++i) {
    seen.area[i] = (bx[i] - ax[i]) * (cy[i] - ay[i]) - (cx[i] - ax[i]) * (by[i] - ay[i]);
    // The middle of pixel k is at k + 1/2.
    seen.left[i] = -below(slack + 0.5f - std::min(ax[i], std::min(bx[i], cx[i])));
    seen.columns[i] =
        below(std::max(ax[i], std::max(bx[i], cx[i])) + slack - 0.5f) - seen.left[i] + 1;
    seen.bottom[i] = -below(slack + 0.5f - std::min(ay[i], std::min(by[i], cy[i])));
    seen.rows[i] =
        below(std::max(ay[i], std::max(by[i], cy[i])) + slack - 0.5f) - seen.bottom[i] + 1;
  }
}

/// Tells whether the triangle may hold one of the middles in its box.
bool holdsMiddle(const SeenCluster& seen, std::size_t i) {
  const float turn = seen.area[i] < 0.0f ? -1.0f : 1.0f;
  const glm::vec2 first(float(seen.left[i]) + 0.5f, float(seen.bottom[i]) + 0.5f);
  std::array<glm::vec3, 3> inside{};  // positive on the triangle's side of an edge
  float around = 0.0f;
  for (std::size_t c = 0; c < 3; ++c) {
    const std::size_t next = (c + 1) % 3;
    const float dx = turn * (seen.cornerX[next][i] - seen.cornerX[c][i]);
    const float dy = turn * (seen.cornerY[next][i] - seen.cornerY[c][i]);
    inside[c] = {-dy, dx,
                 dx * (first.y - seen.cornerY[c][i]) - dy * (first.x - seen.cornerX[c][i])};
    around += std::abs(dx) + std::abs(dy);
  }
  // By no more than this do moves of corners within the slack change what lies within the box.
  for (glm::vec3& edge : inside)
    edge.z += slack * (std::abs(edge.x) + std::abs(edge.y) + around);
  for (int row = 0; row < seen.rows[i]; ++row)
    for (int column = 0; column < seen.columns[i]; ++column) {
      const glm::vec3 step(float(column), float(row), 1.0f);
      if (glm::dot(inside[0], step) >= 0.0f && glm::dot(inside[1], step) >= 0.0f &&
          glm::dot(inside[2], step) >= 0.0f)
        return true;
    }
  return false;
}

/// Appends the triangles of clusters.
class TriangleFinder {
 public:
  TriangleFinder(const DrawnStructure& shown, const PictureView& view, const SampleGrid& grid)
      : m_shown(shown), m_view(view), m_grid(grid), m_cull(cullsBack(shown, view)) {}

  void append(const model::Cluster& cluster, std::vector<std::uint32_t>& visible) {
    const Clusters& clusters = m_shown.surface().clusters;
    const auto* triangles = clusters.localTriangles.data() + cluster.firstTriangle;
    const bool mixed = m_cull && model::facing(cluster, m_view.eye()) != model::Facing::front;
    const bool known = project(cluster, m_shown, m_view, m_grid, m_seen);
    if (known)
      findBoxes(cluster.triangleCount, triangles, m_seen);
    for (std::uint32_t i = 0; i < cluster.triangleCount; ++i) {
      if (known ? (mixed && !(m_seen.area[i] > 0.0f)) || !covers(i)
                : mixed && !facesEye(cluster, triangles[i]))
        continue;
      for (const std::uint8_t corner : triangles[i])
        visible.push_back(cluster.firstVertex + corner);
    }
  }

 private:
  bool covers(std::size_t i) const {
    const int columns = m_seen.columns[i];
    const int rows = m_seen.rows[i];
    if (columns <= 0 || rows <= 0)
      return false;
    return columns > mostMiddles || columns * rows > mostMiddles || holdsMiddle(m_seen, i);
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
    for (std::size_t k = i * piece; k < end; ++k)
      finder.append(*clusters[k], found[i]);
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
