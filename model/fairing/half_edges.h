// SPDX-License-Identifier: Apache-2.0
// Finds which triangles meet at which edges. Half-edge 3·t + k runs from corner k of triangle t to
// the next corner.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/geometry/mesh.h"

namespace sline::model {

class HalfEdges {
 public:
  static constexpr std::uint32_t open = 0xffffffffu;    ///< no other triangle at this edge
  static constexpr std::uint32_t shared = 0xfffffffeu;  ///< three or more triangles at this edge

  HalfEdges(std::size_t vertexCount, std::span<const Triangle> triangles);

  /// Returns the other half-edge of the same edge, whatever its direction; `open` or `shared`
  /// without one.
  std::uint32_t opposite(std::uint32_t halfEdge) const { return m_opposite[halfEdge]; }
  bool hasOpposite(std::uint32_t halfEdge) const { return m_opposite[halfEdge] < shared; }
  std::size_t count() const { return m_opposite.size(); }
  std::size_t openCount() const { return m_openCount; }
  std::size_t sharedCount() const { return m_sharedCount; }

 private:
  std::vector<std::uint32_t> m_opposite;
  std::size_t m_openCount = 0;
  std::size_t m_sharedCount = 0;  ///< counts half-edges, not edges
};

/// Returns the next half-edge of the same triangle.
inline std::uint32_t nextInTriangle(std::uint32_t halfEdge) {
  return halfEdge % 3 == 2 ? halfEdge - 2 : halfEdge + 1;
}

}  // namespace sline::model
