// SPDX-License-Identifier: Apache-2.0
// Gathers neighbouring vertices into groups, so that filters that reach far look at fewer of them:
// each group is a vertex with its ring, and those left between groups join one of them, as in
// aggregation multigrid (P. Vaněk, J. Mandel, M. Brezina, "Algebraic multigrid by smoothed
// aggregation", 1996).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/fairing/vertex_rings.h"

namespace sline::model {

class CoarseRings {
 public:
  explicit CoarseRings(const VertexRings& fine);

  /// Returns the groups' neighbours; a group with a vertex of a border counts as one.
  const VertexRings& rings() const { return m_rings; }
  /// Returns the group of each vertex.
  std::span<const std::uint32_t> groups() const { return m_groups; }
  /// Returns the mean of each group.
  template <class Value>
  std::vector<Value> means(const std::vector<Value>& values) const;

 private:
  static std::vector<std::uint32_t> groupsOf(const VertexRings& fine);
  static VertexRings ringsOf(const VertexRings& fine, std::span<const std::uint32_t> groups);

  std::vector<std::uint32_t> m_groups;
  VertexRings m_rings;
};

template <class Value>
std::vector<Value> CoarseRings::means(const std::vector<Value>& values) const {
  std::vector<Value> means(m_rings.vertexCount(), Value{});
  std::vector<std::uint32_t> counts(means.size(), 0);
  for (std::size_t v = 0; v < values.size(); ++v) {
    means[m_groups[v]] += values[v];
    ++counts[m_groups[v]];
  }
  for (std::size_t group = 0; group < means.size(); ++group)
    means[group] /= float(counts[group]);
  return means;
}

}  // namespace sline::model
