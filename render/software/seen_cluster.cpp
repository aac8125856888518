// SPDX-License-Identifier: Apache-2.0
#include "render/software/seen_cluster.h"

#include <algorithm>
#include <cmath>
#include <glm/mat4x4.hpp>

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

/// The rows of a matrix that project to the picture, in steps of a grid.
struct ProjectedRows {
  glm::mat4 rows;
  glm::vec2 half;  ///< of the picture, px
  glm::vec2 corner;
  float perPixel;
};

struct InRows {
  const float *x, *y, *z;
};
struct OutRows {
  float *x, *y, *depth, *w;
};
struct Missed {
  bool lost;    ///< some lie behind the eye or too far away to tell
  bool beyond;  ///< some lie beyond the view's depths
};

SLINE_WIDE_LOOPS Missed projectRows(const InRows& in, std::size_t count, const ProjectedRows& to,
                                    const OutRows& out) {
  constexpr float nearest = 1e-6f;
  const float *px = in.x, *py = in.y, *pz = in.z;
  float *x = out.x, *y = out.y, *depth = out.depth, *w = out.w;
  const glm::mat4 m = to.rows;
  const glm::vec2 half = to.half, corner = to.corner;
  const float perPixel = to.perPixel;
  std::int32_t lost = 0;
  std::int32_t beyond = 0;
  SLINE_INDEPENDENT_ROUNDS
  for (std::size_t i = 0; i < count; ++i) {
    const float clipW = m[0][3] * px[i] + m[1][3] * py[i] + m[2][3] * pz[i] + m[3][3];
    const float clipX = m[0][0] * px[i] + m[1][0] * py[i] + m[2][0] * pz[i] + m[3][0];
    const float clipY = m[0][1] * px[i] + m[1][1] * py[i] + m[2][1] * pz[i] + m[3][1];
    const float clipZ = m[0][2] * px[i] + m[1][2] * py[i] + m[2][2] * pz[i] + m[3][2];
    const float pixelX = (clipX / clipW + 1.0f) * half.x;
    const float pixelY = (clipY / clipW + 1.0f) * half.y;
    const float deep = 0.5f * (clipZ / clipW) + 0.5f;
    lost |= std::int32_t(!(clipW > nearest)) | std::int32_t(!(std::abs(pixelX) < farthest)) |
            std::int32_t(!(std::abs(pixelY) < farthest));
    beyond |= std::int32_t(!(deep >= 0.0f)) | std::int32_t(!(deep <= 1.0f));
    x[i] = (pixelX - corner.x) * perPixel;
    y[i] = (pixelY - corner.y) * perPixel;
    depth[i] = deep;
    w[i] = clipW;
  }
  return {lost != 0, beyond != 0};
}

/// How far outside of a triangle the slack reaches, along an edge that falls like that.
inline float slackOf(float perColumn, float perRow) {
  return SeenCluster::slack * (std::abs(perColumn) + std::abs(perRow));
}

}  // namespace

bool SeenCluster::project(const model::Cluster& cluster, const ClusterPlaces& places,
                          const PictureView& view, const SampleGrid& grid) {
  std::array<Vertices, 3> found;
  std::array<const float*, 3> position{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    position[axis] = places.clusters.cornerRow(cluster, axis);
    if (position[axis])
      continue;
    position[axis] = found[axis].data();
    const std::uint32_t* vertices = places.clusters.vertices.data() + cluster.firstVertex;
    for (std::uint32_t i = 0; i < cluster.vertexCount; ++i)
      found[axis][i] = places.positions[vertices[i]][int(axis)];
  }
  const auto [lost, beyond] = projectRows(
      {position[0], position[1], position[2]}, cluster.vertexCount,
      {view.viewProjection(), 0.5f * view.size(), glm::vec2(grid.corner), 1.0f / float(grid.step)},
      {x.data(), y.data(), depth.data(), w.data()});
  withinDepths = !beyond;
  return !lost;
}

SLINE_WIDE_LOOPS void SeenCluster::findBoxes(
    std::span<const std::array<std::uint8_t, 3>> triangles) {
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      cornerX[c][i] = x[triangles[i][c]];
      cornerY[c][i] = y[triangles[i][c]];
      cornerDepth[c][i] = depth[triangles[i][c]];
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

SLINE_WIDE_LOOPS void SeenCluster::findSlopes(std::size_t count, Corners corners) {
  const auto& [ax, bx, cx] = cornerX;
  const auto& [ay, by, cy] = cornerY;
  const auto& [az, bz, cz] = cornerDepth;
  // By no more than this do moves of corners within the slack change what lies within the box.
  const float rounded = corners == Corners::rounded ? 1.0f : 0.0f;
  for (std::size_t i = 0; i < count; ++i) {
    const float firstX = float(left[i]) + 0.5f, firstY = float(bottom[i]) + 0.5f;
    const float turn = area[i] < 0.0f ? -1.0f : 1.0f;
    const float abX = turn * (bx[i] - ax[i]), abY = turn * (by[i] - ay[i]);
    const float bcX = turn * (cx[i] - bx[i]), bcY = turn * (cy[i] - by[i]);
    const float caX = turn * (ax[i] - cx[i]), caY = turn * (ay[i] - cy[i]);
    const float moves = rounded * (slackOf(abX, abY) + slackOf(bcX, bcY) + slackOf(caX, caY));
    inside[0].perColumn[i] = -abY;
    inside[0].perRow[i] = abX;
    inside[0].first[i] =
        abX * (firstY - ay[i]) - abY * (firstX - ax[i]) + (slackOf(abX, abY) + moves);
    inside[1].perColumn[i] = -bcY;
    inside[1].perRow[i] = bcX;
    inside[1].first[i] =
        bcX * (firstY - by[i]) - bcY * (firstX - bx[i]) + (slackOf(bcX, bcY) + moves);
    inside[2].perColumn[i] = -caY;
    inside[2].perRow[i] = caX;
    inside[2].first[i] =
        caX * (firstY - cy[i]) - caY * (firstX - cx[i]) + (slackOf(caX, caY) + moves);
    least[i] = std::min(az[i], std::min(bz[i], cz[i]));
    most[i] = std::max(az[i], std::max(bz[i], cz[i]));
    // Across a triangle that is seen edge on the nearest corner's depth is as good as any.
    const float perArea = area[i] == 0.0f ? 0.0f : 1.0f / area[i];
    const float ab = bz[i] - az[i], ac = cz[i] - az[i];
    const float perColumn = (ab * (cy[i] - ay[i]) - ac * (by[i] - ay[i])) * perArea;
    const float perRow = (ac * (bx[i] - ax[i]) - ab * (cx[i] - ax[i])) * perArea;
    steepness.perColumn[i] = perColumn;
    steepness.perRow[i] = perRow;
    const float start = area[i] == 0.0f ? least[i] : az[i];
    steepness.first[i] = start + perColumn * (firstX - ax[i]) + perRow * (firstY - ay[i]);
  }
}

}  // namespace sline::render
