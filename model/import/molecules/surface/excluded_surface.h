// SPDX-License-Identifier: Apache-2.0
// Makes the solvent-excluded surface: the boundary of the space that a probe rolling over the atoms
// cannot enter (Richards 1977; Connolly, J. Appl. Cryst. 16, 1983). It is where the distance to the
// solvent-accessible surface equals the probe's radius (Xu & Zhang, PLoS ONE 4, 2009). They take
// that distance from a grid; here it is exact, to the nearest patch, arc or corner, so neither the
// lattice nor its orientation leaves a mark and each vertex lies on the surface.
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <span>

#include "model/import/molecules/surface/lattice_mesh.h"
#include "model/import/molecules/surface/solvent_accessible.h"

namespace sline::model {

/// The radius of a water molecule, in ångström.
inline constexpr double probeRadius = 1.4;

/// Returns the excluded surface. `accessible` is that of the atoms grown by `probeRadius`. Closed
/// voids stay only where one of `guests` lies in them: others are never seen, and would be holes in
/// a cut face.
TriangleMesh excludedSurface(const SolventAccessible& accessible,
                             std::span<const glm::dvec3> guests, double spacing,
                             const std::function<bool()>& goesOn);

}  // namespace sline::model
