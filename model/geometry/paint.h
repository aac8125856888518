// SPDX-License-Identifier: Apache-2.0
// Defines what a person has painted over a surface, and finds it again on another surface of the
// same thing.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "model/geometry/mesh.h"

namespace sline::model {

/// Holds one value for each vertex of a mesh, 0: nothing is painted there, to 255: all of it is.
using Paint = std::vector<std::uint8_t>;
using PaintPtr = std::shared_ptr<const Paint>;

struct CarriedPaint {
  PaintPtr paint;     ///< one value per vertex of the other mesh; null where nothing is left
  float lost = 0.0f;  ///< share of what was painted near which the other mesh has no surface, 0 … 1
};

/// Returns the paint of a mesh on another one, by position: each vertex takes what is painted at
/// the nearest point of the first mesh, unless that lies farther away than the meshes' edges are
/// long and a hundredth of their size. Order and number of vertices have no effect. The paint has a
/// value for each vertex of the first.
CarriedPaint carriedPaint(const MeshPtr& from, const Paint& paint, const MeshPtr& to);

}  // namespace sline::model
