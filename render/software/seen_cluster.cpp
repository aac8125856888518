// SPDX-License-Identifier: Apache-2.0
#include "render/software/seen_cluster.h"

#include <algorithm>
#include <cmath>

#include "model/base/wide_loops.h"

namespace sline::render {

namespace {

/// Farther from the picture's corner floats do not resolve the slack.
constexpr float farthest = 8192.0f;

/// Rounds down; `x` lies within ±`farthest`.
std::int32_t below(float x) {
  const auto whole = std::int32_t(x);
  return whole - std::int32_t(float(whole) > x);
}

}  // namespace

SLINE_WIDE_LOOPS bool SeenCluster::project(const model::Cluster& cluster,
                                           const ClusterPlaces& places, const PictureView& view,
                                           const SampleGrid& grid) {
  const glm::mat4& m = view.viewProjection();
  const glm::vec2 half = 0.5f * view.size();
  const glm::vec2 corner(grid.corner);
  const float perPixel = 1.0f / float(grid.step);
  const std::uint32_t* vertices = places.clusters.vertices.data() + cluster.firstVertex;
  const std::span<const glm::vec3> positions = places.positions;
  for (std::uint32_t i = 0; i < cluster.vertexCount; ++i)
    for (int axis = 0; axis < 3; ++axis)
      position[std::size_t(axis)][i] = positions[vertices[i]][axis];
  const auto& [px, py, pz] = position;
  constexpr float nearest = 1e-6f;
  std::int32_t lost = 0;
  std::int32_t beyond = 0;
  for (std::uint32_t i = 0; i < cluster.vertexCount; ++i) {
    w[i] = m[0][3] * px[i] + m[1][3] * py[i] + m[2][3] * pz[i] + m[3][3];
    const float clipX = m[0][0] * px[i] + m[1][0] * py[i] + m[2][0] * pz[i] + m[3][0];
    const float clipY = m[0][1] * px[i] + m[1][1] * py[i] + m[2][1] * pz[i] + m[3][1];
    const float clipZ = m[0][2] * px[i] + m[1][2] * py[i] + m[2][2] * pz[i] + m[3][2];
    x[i] = (clipX / w[i] + 1.0f) * half.x;
    y[i] = (clipY / w[i] + 1.0f) * half.y;
    depth[i] = 0.5f * (clipZ / w[i]) + 0.5f;
    lost |= std::int32_t(!(w[i] > nearest)) | std::int32_t(!(std::abs(x[i]) < farthest)) |
            std::int32_t(!(std::abs(y[i]) < farthest));
    beyond |= std::int32_t(!(depth[i] >= 0.0f)) | std::int32_t(!(depth[i] <= 1.0f));
    x[i] = (x[i] - corner.x) * perPixel;
    y[i] = (y[i] - corner.y) * perPixel;
  }
  withinDepths = beyond == 0;
  return lost == 0;
}

SLINE_WIDE_LOOPS void SeenCluster::findBoxes(
    std::span<const std::array<std::uint8_t, 3>> triangles) {
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      cornerX[c][i] = x[triangles[i][c]];
      cornerY[c][i] = y[triangles[i][c]];
    }
  const auto& [ax, bx, cx] = cornerX;
  const auto& [ay, by, cy] = cornerY;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    area[i] = (bx[i] - ax[i]) * (cy[i] - ay[i]) - (cx[i] - ax[i]) * (by[i] - ay[i]);
    // The middle of pixel k is at k + 1/2.
    left[i] = -below(slack + 0.5f - std::min(ax[i], std::min(bx[i], cx[i])));
    columns[i] = below(std::max(ax[i], std::max(bx[i], cx[i])) + slack - 0.5f) - left[i] + 1;
    bottom[i] = -below(slack + 0.5f - std::min(ay[i], std::min(by[i], cy[i])));
    rows[i] = below(std::max(ay[i], std::max(by[i], cy[i])) + slack - 0.5f) - bottom[i] + 1;
  }
}

}  // namespace sline::render
