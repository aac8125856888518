// SPDX-License-Identifier: Apache-2.0
// Computes what suggestive contours need at a cluster's vertices, for many at once: the values are
// gathered into arrays, so that the processor waits for several vertices at a time and works on
// whole vector registers.
#pragma once

#include "render/lines/ground/cluster_walk.h"

namespace sline::render {

class RadialValues {
 public:
  /// Wants the values of this vertex.
  void want(std::uint8_t local) { m_isWanted[local / 64] |= std::uint64_t(1) << (local % 64); }
  /// Computes the values of all wanted vertices.
  void compute(const ClusterWalk& walk);

  /// ⟨n, d⟩ = nv·|d|, κr (1/mm) and Dκr (1/mm²) as seen from outside, of wanted vertices.
  float facingAt(std::uint8_t local) const { return m_facing[m_place[local]]; }
  float nvAt(std::uint8_t local) const { return m_nv[m_place[local]]; }
  float curvatureAt(std::uint8_t local) const { return m_curvature[m_place[local]]; }
  float derivativeAt(std::uint8_t local) const { return m_derivative[m_place[local]]; }

 private:
  void listWanted();
  void gather(const ClusterWalk& walk);

  static constexpr std::size_t most = model::Clusters::maximumVertices;
  using Row = std::array<float, most>;

  static_assert(most % 64 == 0);
  std::array<std::uint64_t, most / 64> m_isWanted{};  ///< a bit for each vertex
  std::size_t m_count = 0;
  std::array<std::uint8_t, most> m_wanted;
  std::array<std::uint8_t, most> m_place;
  std::array<float, 15 * most> m_rows;  ///< position, normal, e1, k, derivative
  Row m_facing;
  Row m_nv;
  Row m_curvature;
  Row m_derivative;
};

}  // namespace sline::render
