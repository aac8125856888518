// SPDX-License-Identifier: Apache-2.0
// Cuts from a molecule's surface the part that lines the pocket of a guest.
#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "model/import/molecules/surface/lattice_mesh.h"

namespace sline::model {

/// Returns the parts of the surface that lie within `reach` of the guest's places and look towards
/// them, raised a little so that they cover the surface they were cut from; edges are cut smooth.
/// Lengths are in the mesh's unit. Patches of less than a twentieth of the area are left out. The
/// mesh is open, and empty where nothing is near.
TriangleMesh pocketLining(const TriangleMesh& surface, std::span<const glm::vec3> guest,
                          float reach);

}  // namespace sline::model
