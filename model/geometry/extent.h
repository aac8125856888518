// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "model/geometry/mesh.h"

namespace sline::model {

struct Extent {
  double area = 0.0;  ///< mm², of all triangles
  std::optional<double>
      volume;  ///< mm³; absent where the surface has holes or edges of three faces
};

/// By the divergence theorem: a sixth of the sum of the triangles' determinants. A surface turned
/// inside out has the volume of the other.
Extent extentOf(const Mesh& mesh);

}  // namespace sline::model
