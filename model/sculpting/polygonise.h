// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/geometry/mesh.h"
#include "model/sculpting/implicit.h"
#include "model/sculpting/remesh.h"

namespace sline::model {

/// Returns the surface field = 0 within the box (which it must not touch) as a closed mesh with
/// outward normals and edges of about `edge` mm: flying edges make it, then vertices are spread
/// evenly within the surface and put back onto it, so that triangles are nearly equilateral and
/// curvature is smooth.
MeshPtr polygonise(const Field& field, const Box& box, float edge);

/// Returns the surface from triangles that already lie within an edge of it and are only moved onto
/// it.
MeshPtr fitted(Facets pattern, const Field& field, float edge);

}  // namespace sline::model
