// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <glm/vec3.hpp>

#include "model/geometry/mesh.h"

namespace sline::model {

/// Describes the rest of a mesh after everything near another structure is taken away.
struct Cut {
  bool ends = true;    ///< whether the rest of each connected part that comes near is one piece
  double share = 0.0;  ///< share of the surface that was taken away
};

/// Tells whether a place is nearer to the other structure than that many mm.
using IsNearer = std::function<bool(const glm::vec3& place, float distance)>;

/// Takes away what is nearer than `width`. A vessel that ends at the structure leaves one piece,
/// one that passes by leaves two. Pieces of less than a tenth of their part do not count.
Cut cutNear(const Mesh& mesh, float width, const IsNearer& isNearer);

}  // namespace sline::model
