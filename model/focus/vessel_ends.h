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

/// Takes the mesh apart. A vessel that ends at the structure leaves one piece, one that passes by
/// leaves two. Pieces of less than a tenth of their part do not count.
Cut cutNear(const Mesh& mesh, const std::function<bool(const glm::vec3&)>& near);

}  // namespace sline::model
