// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/geometry/mesh.h"

namespace sline::model {

/// A surface cut open wherever a half-edge structure cannot represent it: at edges of three
/// triangles or more, at edges whose two triangles disagree about which side is outside, and at
/// vertices where several fans of triangles touch. Each fan gets its own vertex at the place of the
/// original one. Corner and half-edge 3·t + k are those of HalfEdges.
struct CutSurface {
  std::vector<std::uint32_t> corners;  ///< the vertex at each corner
  std::vector<std::uint32_t>
      opposites;  ///< across each half-edge; HalfEdges::open at rims and cuts
  std::vector<std::uint32_t> originals;  ///< for each vertex the one from which it was cut
  std::vector<std::uint32_t> copies;     ///< the next vertex of the same original, in a circle
  std::vector<char> rims;                ///< for each vertex whether its fan is open

  bool isCopied(std::uint32_t vertex) const { return copies[vertex] != vertex; }
};

/// Cuts the surface open. Vertices without triangles have no copy in the cut surface.
CutSurface cutOpen(std::size_t vertexCount, std::span<const Triangle> triangles);

}  // namespace sline::model
