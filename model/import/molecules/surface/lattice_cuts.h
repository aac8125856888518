// SPDX-License-Identifier: Apache-2.0
// Represents the points where a surface cuts the edges of the body-centred cubic lattice, and makes
// the mesh through them.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <vector>

#include "model/import/molecules/surface/lattice_mesh.h"

namespace sline::model {

/// A lattice point is given in half spacings: all three coordinates are even (corners of the cubes)
/// or all odd (their centres).
struct LatticePoint {
  std::int32_t x = 0;
  std::int32_t y = 0;
  std::int32_t z = 0;
  auto operator<=>(const LatticePoint&) const = default;
};

/// A cut lies on a lattice edge that has its ends on either side of the surface.
struct Cut {
  LatticePoint inside;
  LatticePoint outside;
  float share = 0.5f;      ///< the share of the edge that lies inside
  glm::vec3 place;         ///< on the surface
  glm::vec3 insidePlace;   ///< the surface's point next to the inner end
  glm::vec3 outsidePlace;  ///< the surface's point next to the outer end
};

struct CutSurface {
  std::vector<Cut> cuts;            ///< may hold the same edge several times
  std::vector<Triangle> triangles;  ///< indices into `cuts`
};

/// Makes one vertex of cuts on the same edge, and of all cuts around a lattice point that nearly
/// lies on the surface. Lattice points are left alone where the mesh would not stay a manifold.
TriangleMesh meshOf(CutSurface surface);

}  // namespace sline::model
