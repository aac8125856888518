// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <glm/vec3.hpp>

#include "model/geometry/mesh.h"

namespace sline::model {

/// What comes of a mesh when all of it that is near something is taken away.
struct Cut {
  bool ends = true;    ///< of each connected part that comes near, what is left hangs together
  double share = 0.0;  ///< of the surface that went
};

/// A vessel that ends at something leaves one piece, one that passes by leaves two. Pieces of less
/// than a tenth of their part count for nothing.
Cut cutNear(const Mesh& mesh, const std::function<bool(const glm::vec3&)>& near);

}  // namespace sline::model
