// SPDX-License-Identifier: Apache-2.0
// Takes the steps out of surfaces that come from slices, for drawing them (METHOD §11.7).
#pragma once

#include "model/geometry/mesh.h"

namespace sline::model {

/// The share of the distance between slices by which fairing may move a vertex.
inline constexpr float fairingShare = 0.75f;

/// Returns the surface without what swings within a few slices: terraces, and outlines that were
/// drawn slice by slice. Waves shorter than some twenty slices are taken out along the normal as
/// far as the bound allows, `fairingShare` of the distance; what a whole neighbourhood would move
/// by, and the volume, are given back, so that thin vessels keep their width. Triangles and their
/// order stay, borders too, and no vertex leaves the mesh's own box. `sliceDistance` is in mm; at 0
/// the same mesh is returned.
MeshPtr faired(const MeshPtr& mesh, float sliceDistance);

/// Returns a copy averaged with the weights of a Gaussian of that standard deviation, in mm,
/// without waves shorter than some five times as much. Its normals and curvature are those of the
/// larger forms; its positions may lie well off. Borders stay.
MeshPtr withoutSmallForms(const Mesh& mesh, float deviation);

}  // namespace sline::model
