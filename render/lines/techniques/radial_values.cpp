// SPDX-License-Identifier: Apache-2.0
#include "render/lines/techniques/radial_values.h"

#include <bit>

namespace sline::render {

void RadialValues::listWanted() {
  m_count = 0;
  for (std::size_t word = 0; word < m_isWanted.size(); ++word)
    for (std::uint64_t bits = m_isWanted[word]; bits != 0; bits &= bits - 1) {
      const std::size_t local = 64 * word + std::size_t(std::countr_zero(bits));
      m_place[local] = std::uint8_t(m_count);
      m_wanted[m_count++] = std::uint8_t(local);
    }
}

void RadialValues::compute(const ClusterWalk& walk) {
  listWanted();
  gather(walk);
  const float* in = m_rows.data();
  float* facing = m_facing.data();
  float* nv = m_nv.data();
  float* curvature = m_curvature.data();
  float* derivative = m_derivative.data();
  const glm::vec3 eye = walk.eye().value;
  // In a parallel projection d is the eye's direction itself.
  const float scale = walk.eye().atInfinity ? 0.0f : 1.0f;
  const std::size_t count = m_count;
  // This straight loop over rows becomes vector instructions in the compiler.
  for (std::size_t i = 0; i < count; ++i) {
    const auto row = [&](std::size_t which) { return in[which * most + i]; };
    const glm::vec3 d = eye - scale * glm::vec3(row(0), row(1), row(2));
    const glm::vec3 n(row(3), row(4), row(5));
    const glm::vec3 e1(row(6), row(7), row(8));
    const glm::vec2 k(row(9), row(10));
    facing[i] = glm::dot(n, d);
    nv[i] = cosineOf(facing[i], glm::dot(d, d));
    curvature[i] = radialCurvatureTowards(n, e1, k, d);
    derivative[i] = radialCurvatureDerivative(k, glm::vec4(row(11), row(12), row(13), row(14)),
                                              viewInPrincipalFrame(n, e1, d), nv[i]);
  }
}

void RadialValues::gather(const ClusterWalk& walk) {
  for (std::size_t i = 0; i < m_count; ++i)
    walk.fetch(m_wanted[i]);
  for (std::size_t i = 0; i < m_count; ++i) {
    const model::SurfaceVertex& v = walk.shapeAt(m_wanted[i]);
    float* row = m_rows.data() + i;
    const auto put = [&](float value) {
      *row = value;
      row += most;
    };
    for (const glm::vec3& values : {v.position, v.normal, v.e1})
      for (glm::length_t c = 0; c < 3; ++c)
        put(values[c]);
    put(v.k.x);
    put(v.k.y);
    for (glm::length_t c = 0; c < 4; ++c)
      put(v.derivative[c]);
  }
}

}  // namespace sline::render
