// SPDX-License-Identifier: Apache-2.0
#include "render/lines/techniques/bending_signs.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>

#include "model/base/wide_loops.h"

namespace sline::render {

namespace {
// Beyond this sine of the angle by which the direction to the eye turns within a cluster, its
// bounds say too little.
constexpr float widestTurn = 0.5f;
// The rounding of what is compared, times the largest |κ|, for a d as long as it may be.
constexpr float rounding = 3e-5f;

/// How a cluster is seen: d and the cluster's radius in units of the distance of its centre.
struct ClusterView {
  glm::vec3 d;   ///< from the centre
  float radius;  ///< 0 for a parallel projection
  bool narrow;   ///< its bounds say enough
};

ClusterView viewOf(const model::Cluster& cluster, const model::EyePoint& eye) {
  if (eye.atInfinity)
    return {.d = eye.value, .radius = 0.0f, .narrow = true};
  const glm::vec3 d = eye.value - cluster.bounds.centre;
  const float distance = glm::length(d);
  const float radius = cluster.bounds.radius;
  if (!(radius < widestTurn * distance))
    return {.d = d, .radius = radius, .narrow = false};
  return {.d = d / distance, .radius = radius / distance, .narrow = true};
}

/// Returns dᵀ·S·d.
float bending(const glm::vec3& d, const std::array<float, 6>& s) {
  return d.x * (s[0] * d.x + 2.0f * (s[1] * d.y + s[2] * d.z)) +
         d.y * (s[3] * d.y + 2.0f * s[4] * d.z) + s[5] * d.z * d.z;
}
}  // namespace

bool mayBendBothWays(const model::Cluster& cluster, const model::EyePoint& eye) {
  if (cluster.candidateTriangles == 0)
    return false;
  const ClusterView view = viewOf(cluster, eye);
  if (!view.narrow)
    return true;
  // For unit vectors d and m, dᵀSd − mᵀSm = (d − m)ᵀS(d + m), and |d − m| ≤ 1.04·radius.
  const model::TensorBounds& bounds = cluster.tensorBounds;
  return !(std::abs(bending(view.d, bounds.middle)) >
           bounds.spread + bounds.largest * (2.1f * view.radius + rounding));
}

namespace {

/// What the loop over a cluster's candidates reads.
struct BendingRows {
  const std::uint8_t* places;
  std::size_t vertices;
  const std::uint8_t* tensors;
  std::size_t candidates;
};

// The straight loop over arrays becomes vector instructions in the compiler.
SLINE_WIDE_LOOPS
void findBendings(const BendingRows& rows, const ClusterView& view,
                  const model::TensorBounds& bounds, float* bendings) {
  constexpr float none = model::Clusters::mostSteps;
  const float place = view.radius / none;
  const float step = bounds.step;
  const glm::vec3 d = view.d + none * place;
  std::array<float, 6> s = bounds.middle;
  for (float& number : s)
    number -= none * step;
  const std::uint8_t* p = rows.places;
  const std::uint8_t* t = rows.tensors;
  const std::size_t vertices = rows.vertices;
  const std::size_t count = rows.candidates;
  for (std::size_t i = 0; i < count; ++i) {
    const float x = d.x - place * float(p[i]);
    const float y = d.y - place * float(p[vertices + i]);
    const float z = d.z - place * float(p[2 * vertices + i]);
    bendings[i] = x * ((s[0] + step * float(t[i])) * x +
                       2.0f * ((s[1] + step * float(t[count + i])) * y +
                               (s[2] + step * float(t[2 * count + i])) * z)) +
                  y * ((s[3] + step * float(t[3 * count + i])) * y +
                       2.0f * (s[4] + step * float(t[4 * count + i])) * z) +
                  (s[5] + step * float(t[5 * count + i])) * z * z;
  }
}

}  // namespace

float BendingSigns::estimate(const ClusterWalk& walk) {
  const model::Cluster& cluster = walk.cluster();
  const model::TensorBounds& bounds = cluster.tensorBounds;
  const std::size_t count = cluster.candidateVertices;
  const ClusterView view = viewOf(cluster, walk.eye());
  if (!view.narrow) {
    std::fill_n(m_bending.begin(), count, 0.0f);
    return 0.0f;
  }
  const std::uint8_t* places = walk.samples();
  findBendings({places, cluster.vertexCount,
                places + model::Clusters::placeRows * cluster.vertexCount, count},
               view, bounds, m_bending.data());
  // Half a step of each number of S, and of each coordinate: √¾ / 127 of the radius, where d is at
  // most 1.5 long.
  const float longest =
      std::abs(view.d.x) + std::abs(view.d.y) + std::abs(view.d.z) + 1.74f * view.radius;
  return 0.51f * bounds.step * longest * longest +
         bounds.largest * (0.021f * view.radius + rounding);
}

bool BendingSigns::find(const ClusterWalk& walk) {
  const std::size_t count = walk.cluster().candidateVertices;
  const float open = estimate(walk);
  walk.settle({m_bending.data(), count}, open, [&](std::uint8_t i) { return walk.bendingAt(i); });
  return m_signs.take({m_bending.data(), count});
}

}  // namespace sline::render
