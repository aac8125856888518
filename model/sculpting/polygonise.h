// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/geometry/mesh.h"
#include "model/sculpting/implicit.h"
#include "model/sculpting/remesh.h"

namespace sline::model {

/// The surface field = 0 within the box (which it must not touch) as a closed mesh with outward
/// normals and edges of about `edge` mm: flying edges, then vertices are spread evenly within the
/// surface and put back onto it, so that triangles are near equilateral and curvature is smooth.
MeshPtr polygonise(const Field& field, const Box& box, float edge);

/// The same from triangles that lie within an edge of the surface already: only put onto it.
MeshPtr fitted(Facets pattern, const Field& field, float edge);

}  // namespace sline::model
