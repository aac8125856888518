// SPDX-License-Identifier: Apache-2.0
#include "render/lines/hatch_tone.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "render/lines/view_fields.h"

namespace sline::render {

namespace {
/// Returns acos(x) / (π/2) for x in 0 … 1, within 5·10⁻⁵ (M. Abramowitz, I. Stegun, "Handbook of
/// Mathematical Functions", 4.4.45); the library's function keeps the loop from being vectorised.
float quarterTurns(float x) {
  return 0.63661977f * std::sqrt(1.0f - x) *
         (1.5707288f + x * (-0.2121144f + x * (0.0742610f - 0.0187293f * x)));
}

// Cosines to the light: below the first all is shadow, above the second nothing.
constexpr float wholeShadow = -0.35f;
constexpr float noShadow = 0.3f;
constexpr float shadowWeight = 0.45f;
// The second, where hatching is as dark as a woodcut's; it begins where tones for print end.
constexpr float noShadowWhereDark = 0.95f;
constexpr float usualTone = 1.8f;
constexpr float woodcutTone = 2.4f;

/// Returns the cosine to the light from which on there is no shadow.
float endOfShadow(float tone) {
  const float dark = std::clamp((tone - usualTone) / (woodcutTone - usualTone), 0.0f, 1.0f);
  return noShadow + dark * (noShadowWhereDark - noShadow);
}

/// Where the fields go, one entry for each of Clusters::vertices.
struct FieldArrays {
  float* weight;
  float* angle;
};

/// Tells what a cluster's vertices say of its hatching.
struct ClusterTone {
  bool hatched = false;
  bool front = false;
};

using FieldOfCluster = std::array<float, model::Clusters::maximumVertices>;

/// What is known of a cluster's vertices, an array of each number.
struct ClusterArrays {
  std::array<FieldOfCluster, 3> position;
  std::array<FieldOfCluster, 3> normal;
  std::array<FieldOfCluster, 3> e1;
  std::array<FieldOfCluster, 2> k;

  ClusterArrays(const model::Surface& surface, const model::Cluster& cluster) {
    for (std::uint32_t i = 0; i < cluster.vertexCount; ++i) {
      const model::SurfaceVertex& at =
          surface.vertices[surface.clusters.vertices[cluster.firstVertex + i]];
      for (int axis = 0; axis < 3; ++axis) {
        position[std::size_t(axis)][i] = at.position[axis];
        normal[std::size_t(axis)][i] = at.normal[axis];
        e1[std::size_t(axis)][i] = at.e1[axis];
      }
      k[0][i] = at.k[0];
      k[1][i] = at.k[1];
    }
  }
};

/// Has the memory fetch a cluster's vertices, which lie about, while another is worked on.
void fetch(const model::Surface& surface, const model::Cluster& cluster) {
  for (std::uint32_t i = 0; i < cluster.vertexCount; ++i)
    __builtin_prefetch(&surface.vertices[surface.clusters.vertices[cluster.firstVertex + i]]);
}

/// Computes the fields of a cluster by METHOD §3: k = S w + (nv/d)·w. Seen from behind, n and S
/// change sign and w does not, so k turns. All is written number by number, and without branches,
/// so that several vertices are computed at once.
template <bool atInfinity>
ClusterTone computeFields(const ClusterArrays& in, const model::Cluster& cluster,
                          const HatchView& view, float filigreeSize, FieldArrays out) {
  const auto& [px, py, pz] = in.position;
  const auto& [normalX, normalY, normalZ] = in.normal;
  const auto& [ax, ay, az] = in.e1;
  const auto& [k1, k2] = in.k;
  const glm::vec3 eye = view.eye.value;
  const glm::vec3 light = view.light;
  const float turned = view.twoSided ? -1.0f : 1.0f;
  const float shadowRange = endOfShadow(view.tone) - wholeShadow;
  // Arrays of its own, of which the compiler knows that they are no input.
  FieldOfCluster weights;
  FieldOfCluster angles;
  int hatched = 0;
  int front = 0;
  for (std::uint32_t i = 0; i < cluster.vertexCount; ++i) {
    const float nx = normalX[i], ny = normalY[i], nz = normalZ[i];
    const float toX = atInfinity ? eye.x : eye.x - px[i];
    const float toY = atInfinity ? eye.y : eye.y - py[i];
    const float toZ = atInfinity ? eye.z : eye.z - pz[i];
    const float distance = std::sqrt(toX * toX + toY * toY + toZ * toZ);
    const float length = std::max(distance, 1e-20f);
    const float vx = toX / length, vy = toY / length, vz = toZ / length;
    const float nv = nx * vx + ny * vy + nz * vz;
    const float wx = vx - nv * nx, wy = vy - nv * ny, wz = vz - nv * nz;
    // e2 = n × e1
    const float bx = ny * az[i] - nz * ay[i];
    const float by = nz * ax[i] - nx * az[i];
    const float bz = nx * ay[i] - ny * ax[i];
    const float alongFirst = k1[i] * (wx * ax[i] + wy * ay[i] + wz * az[i]);
    const float alongSecond = k2[i] * (wx * bx + wy * by + wz * bz);
    const float near = atInfinity ? 0.0f : nv / distance;
    const float kx = alongFirst * ax[i] + alongSecond * bx + near * wx;
    const float ky = alongFirst * ay[i] + alongSecond * by + near * wy;
    const float kz = alongFirst * az[i] + alongSecond * bz + near * wz;
    const float side = nv < 0.0f ? turned : 1.0f;
    const float facing = side * nv;
    const float towards = side * (nx * light.x + ny * light.y + nz * light.z);
    const float lit = std::min(std::max((towards - wholeShadow) / shadowRange, 0.0f), 1.0f);
    const float shadow = 1.0f - lit * lit * (3.0f - 2.0f * lit);
    const float weight =
        std::max(-side * (kx * vx + ky * vy + kz * vz) * filigreeSize, shadowWeight * shadow);
    const float behind = 1.0f - facing;
    const float before = quarterTurns(std::min(facing, 1.0f));
    const float angle = facing > 0.0f ? before : behind;
    weights[i] = weight;
    angles[i] = angle;
    front |= int(angle < 1.0f);
    hatched |= int(angle < 1.0f) & int(weight > 0.0f);
  }
  std::copy_n(weights.begin(), cluster.vertexCount, out.weight + cluster.firstVertex);
  std::copy_n(angles.begin(), cluster.vertexCount, out.angle + cluster.firstVertex);
  return {hatched != 0, front != 0};
}

constexpr std::size_t tableSize = 64;

std::array<float, tableSize + 2> widthTable() {
  std::array<float, tableSize + 2> table{};
  for (std::size_t i = 0; i < table.size(); ++i)
    table[i] = 0.62f * std::pow(float(i) / float(tableSize), 1.2f);
  return table;
}
}  // namespace

float hatchWidth(float opacity) {
  static const std::array<float, tableSize + 2> table = widthTable();
  const float x = std::sqrt(std::clamp(opacity, 0.0f, 1.0f)) * float(tableSize);
  const std::size_t i = std::size_t(x);
  return table[i] + (x - float(i)) * (table[i + 1] - table[i]);
}

HatchFields::HatchFields(const model::Surface& surface, const HatchView& view)
    : m_weight(std::make_unique_for_overwrite<float[]>(surface.clusters.vertices.size())),
      m_angle(std::make_unique_for_overwrite<float[]>(surface.clusters.vertices.size())),
      m_front(surface.clusters.items.size(), 0) {
  const model::Clusters& clusters = surface.clusters;
  const FieldArrays arrays{m_weight.get(), m_angle.get()};
  std::vector<std::uint32_t> front;
  front.reserve(clusters.items.size());
  for (std::size_t c = 0; c < clusters.items.size(); ++c)
    if (view.twoSided || model::facing(clusters.items[c], view.eye) != model::Facing::back)
      front.push_back(std::uint32_t(c));
  for (std::size_t i = 0; i < front.size(); ++i) {
    if (i + 1 < front.size())
      fetch(surface, clusters.items[front[i + 1]]);
    const std::uint32_t c = front[i];
    const model::Cluster& cluster = clusters.items[c];
    const ClusterArrays in(surface, cluster);
    const ClusterTone tone =
        view.eye.atInfinity ? computeFields<true>(in, cluster, view, surface.filigreeSize, arrays)
                            : computeFields<false>(in, cluster, view, surface.filigreeSize, arrays);
    m_front[c] = tone.front ? 1 : 0;
    if (tone.hatched)
      m_clusters.push_back(c);
  }
}

}  // namespace sline::render
