// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/geometry/mesh.h"
#include "model/sculpting/implicit.h"
#include "model/sculpting/swept.h"

namespace sline::model {

/// Describes a stretch of a tube, cut square at both ends.
struct TubeStretch {
  float from = 0.0f;  ///< mm along the centre line
  float to = 0.0f;
  float edge = 2.0f;  ///< mm: mean edge of its triangles
  float rim = 2.0f;   ///< mm: radius of the edges of its ends
};

/// Meshes the walls of a long coiled tube as a closed mesh of rings around its centre line, which
/// reach outwards to where `solid`, negative inside, ends, and at most as far as the tube is wide.
/// Unlike in a polygonised field, loops that touch stay apart.
MeshPtr tubeMesh(const Swept& tube, const TubeStretch& stretch, const Field& solid);

}  // namespace sline::model
