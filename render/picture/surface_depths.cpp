// SPDX-License-Identifier: Apache-2.0
#include "render/picture/surface_depths.h"

#include <algorithm>
#include <atomic>

#include "model/base/parallel.h"
#include "render/strokes/coverage.h"

namespace sline::render {

namespace {

struct SeenDepths {
  float a, b, c;
  float least() const { return std::min(a, std::min(b, c)); }
  float most() const { return std::max(a, std::max(b, c)); }
};

/// Fills rows of samples. Bands of rows can be filled at the same time.
class DepthBand {
 public:
  DepthBand(const DrawnStructure& shown, const PictureView& view, const SampleArea& samples,
            std::vector<float>& depths)
      : m_shown(shown),
        m_view(view),
        m_samples(samples),
        m_depths(depths),
        m_cull(cullsBack(shown, view)) {}

  void setRows(int first, int end) {
    m_first = first;
    m_end = end;
  }

  /// Returns false where the cluster has to be clipped.
  bool add(const model::Cluster& cluster) {
    const model::Surface& surface = m_shown.surface();
    if (!m_seen.project(cluster, surface, m_view, m_samples.grid))
      return false;
    const auto* triangles = surface.clusters.localTriangles.data() + cluster.firstTriangle;
    m_seen.findBoxes({triangles, cluster.triangleCount});
    const bool mixed = m_cull && model::facing(cluster, m_view.eye()) != model::Facing::front;
    for (std::uint32_t i = 0; i < cluster.triangleCount; ++i) {
      if (mixed && !(m_seen.area[i] > 0.0f))
        continue;
      const auto [a, b, c] = triangles[i];
      const SeenDepths depths{m_seen.depth[a], m_seen.depth[b], m_seen.depth[c]};
      if (!(depths.least() >= 0.0f && depths.most() <= 1.0f))
        return false;
      if (m_seen.columns[i] > 0 && m_seen.rows[i] > 0)
        draw(i, depths);
    }
    return true;
  }

 private:
  void draw(std::size_t i, const SeenDepths& corners) {
    const PixelRect& area = m_samples.area;
    const int left = std::max(m_seen.left[i], area.x) - m_seen.left[i];
    const int right = std::min(m_seen.left[i] + m_seen.columns[i], area.right()) - m_seen.left[i];
    const int bottom = std::max(m_seen.bottom[i], area.y + m_first) - m_seen.bottom[i];
    const int top = std::min(m_seen.bottom[i] + m_seen.rows[i], area.y + m_end) - m_seen.bottom[i];
    if (left >= right || bottom >= top)
      return;
    const TriangleEdges edges(m_seen, i, TriangleEdges::Corners::exact);
    const glm::vec3& e0 = edges.inside(0);
    const glm::vec3& e1 = edges.inside(1);
    const glm::vec3& e2 = edges.inside(2);
    const glm::vec3 slope = depthSlope(i, corners);
    // A sliver's slope is steep, and samples may lie beside it by the slack.
    const float least = corners.least();
    const float most = corners.most();
    for (int row = bottom; row < top; ++row) {
      const auto y = float(row);
      float* out = m_depths.data() +
                   std::size_t(m_seen.bottom[i] + row - area.y) * std::size_t(area.width) +
                   (m_seen.left[i] - area.x);
      for (int column = left; column < right; ++column) {
        const auto x = float(column);
        const float inside =
            std::min(e0.x * x + e0.y * y + e0.z,
                     std::min(e1.x * x + e1.y * y + e1.z, e2.x * x + e2.y * y + e2.z));
        const float depth = std::min(most, std::max(least, slope.x * x + slope.y * y + slope.z));
        out[column] = inside >= 0.0f && depth < out[column] ? depth : out[column];
      }
    }
  }

  /// Returns the depth's rise per column and per row, and its value at the first middle.
  glm::vec3 depthSlope(std::size_t i, const SeenDepths& corners) const {
    const auto& [ax, bx, cx] = m_seen.cornerX;
    const auto& [ay, by, cy] = m_seen.cornerY;
    const float area = m_seen.area[i];
    if (area == 0.0f)
      return {0.0f, 0.0f, corners.least()};
    const float ab = corners.b - corners.a;
    const float ac = corners.c - corners.a;
    const float x = (ab * (cy[i] - ay[i]) - ac * (by[i] - ay[i])) / area;
    const float y = (ac * (bx[i] - ax[i]) - ab * (cx[i] - ax[i])) / area;
    return {x, y,
            corners.a + x * (float(m_seen.left[i]) + 0.5f - ax[i]) +
                y * (float(m_seen.bottom[i]) + 0.5f - ay[i])};
  }

  const DrawnStructure& m_shown;
  const PictureView& m_view;
  const SampleArea& m_samples;
  std::vector<float>& m_depths;
  bool m_cull;
  int m_first = 0;
  int m_end = 0;
  SeenCluster m_seen;
};

struct PlacedCluster {
  const model::Cluster* cluster;
  int bottom, top;  ///< rows of samples, the last one not included
};

}  // namespace

std::optional<std::vector<float>> surfaceDepths(const DrawnStructure& shown,
                                                const PictureView& view, const TileMask& squares,
                                                const SampleArea& samples) {
  const PixelRect& area = samples.area;
  std::vector<float> depths(std::size_t(area.width) * std::size_t(area.height), 1.0f);
  const bool cull = cullsBack(shown, view);
  std::vector<PlacedCluster> clusters;
  for (const model::Cluster& cluster : shown.surface().clusters.items) {
    if (cull && model::facing(cluster, view.eye()) == model::Facing::back)
      continue;
    const PixelRect bounds = view.bounds(cluster.bounds);
    if (!squares.marksAny(bounds))
      continue;
    // One more on each side: drivers and the bounds round.
    const PixelRect rows = coarser({bounds.x - samples.grid.corner.x,
                                    bounds.y - samples.grid.corner.y, bounds.width, bounds.height},
                                   samples.grid.step);
    clusters.push_back({&cluster, rows.y - 1 - area.y, rows.top() + 1 - area.y});
  }
  constexpr std::size_t clustersPerBand = 256;
  constexpr std::size_t mostBands = 8;
  const std::size_t bands = std::min(mostBands, clusters.size() / clustersPerBand + 1);
  std::atomic<bool> whole = true;
  parallelFor(bands, 1, [&](std::size_t i) {
    const int first = int(std::size_t(area.height) * i / bands);
    const int end = int(std::size_t(area.height) * (i + 1) / bands);
    DepthBand band(shown, view, samples, depths);
    band.setRows(first, end);
    for (const PlacedCluster& placed : clusters)
      if (placed.top > first && placed.bottom < end && !band.add(*placed.cluster)) {
        whole = false;
        return;
      }
  });
  if (!whole)
    return std::nullopt;
  return depths;
}

}  // namespace sline::render
