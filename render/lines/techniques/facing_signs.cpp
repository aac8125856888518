// SPDX-License-Identifier: Apache-2.0
#include "render/lines/techniques/facing_signs.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>

#include "model/base/wide_loops.h"

namespace sline::render {

namespace {

// The rounding of what is compared, in units of the longest d.
constexpr float facingRounding = 2e-6f;
// √¾ of half a step, and a little more: how far three numbers rounded to a step are off.
constexpr float offByRounding = 0.88f;

struct FacingRows {
  const std::uint8_t* samples;
  std::size_t count;
  glm::vec3 d;       ///< from where positions of all zeros stand for
  float place;       ///< a step of positions, 0 for a parallel projection
  glm::vec3 normal;  ///< that of all zeros
  float normalStep;
};

SLINE_WIDE_LOOPS
void findFacings(const FacingRows& rows, float* facings) {
  const std::uint8_t* in = rows.samples;
  const std::size_t count = rows.count;
  const glm::vec3 d = rows.d;
  const glm::vec3 n = rows.normal;
  const float place = rows.place;
  const float step = rows.normalStep;
  for (std::size_t i = 0; i < count; ++i) {
    const float x = d.x - place * float(in[i]);
    const float y = d.y - place * float(in[count + i]);
    const float z = d.z - place * float(in[2 * count + i]);
    facings[i] = x * (n.x + step * float(in[3 * count + i])) +
                 y * (n.y + step * float(in[4 * count + i])) +
                 z * (n.z + step * float(in[5 * count + i]));
  }
}

}  // namespace

bool FacingSigns::find(const ClusterWalk& walk) {
  const model::Cluster& cluster = walk.cluster();
  const model::EyePoint& eye = walk.eye();
  constexpr float none = model::Clusters::mostSteps;
  const std::size_t count = cluster.vertexCount;
  const glm::vec3 d = eye.atInfinity ? eye.value : eye.value - cluster.bounds.centre;
  const float place = eye.atInfinity ? 0.0f : cluster.bounds.radius / none;
  findFacings({.samples = walk.samples(),
               .count = count,
               .d = d + none * place,
               .place = place,
               .normal = cluster.cone.axis - none * cluster.normalStep,
               .normalStep = cluster.normalStep},
              m_facing.data());
  // ⟨n, d⟩ is off by |δn|·|d| + |n|·|δd|, where n is at most 1 + |δn| long.
  const float longest = glm::length(d) + 1.8f * none * place;
  const float offNormal = offByRounding * cluster.normalStep;
  const float open = offNormal * longest + (1.0f + offNormal) * offByRounding * place +
                     facingRounding * (longest + glm::length(eye.value));
  walk.settle({m_facing.data(), count}, open, [&](std::uint8_t i) { return walk.facingAt(i); });
  return m_signs.take({m_facing.data(), count});
}

}  // namespace sline::render
