// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "model/geometry/mesh.h"

namespace sline::model {

struct Extent {
  double area = 0.0;  ///< mm², sum of all triangles
  std::optional<double>
      volume;  ///< mm³; absent where the surface has holes or edges of three faces
};

/// Returns area and volume, the volume by the divergence theorem: a sixth of the sum of the
/// triangles' determinants. A surface turned inside out has the same volume as the original.
Extent extentOf(const Mesh& mesh);

}  // namespace sline::model
