// SPDX-License-Identifier: Apache-2.0
// Reduces a mesh to as few triangles as an error bound allows.
#pragma once

#include <functional>

#include "model/geometry/bvh.h"
#include "model/geometry/mesh.h"

namespace sline::model {

struct Simplified {
  MeshPtr mesh;
  float error = 0.0f;  ///< the largest distance of either surface from the other, mm, as measured
};

/// Returns a mesh of fewer triangles of which no sample lies farther than `bound` (mm, > 0) from
/// the original, nor any sample of the original from it: samples are the vertices and points of a
/// grid on each triangle that lie as close as the original's edges are long, or a sixth of the
/// triangle's own. The bound is measured, not estimated: where a first result breaks it, that place
/// is made finer.
/// A closed surface stays closed, each edge keeps its number of triangles and each piece its
/// handles; rims and edges of three triangles or more stay as they are. The result is the same mesh
/// with error 0 where no triangle could be removed or `goesOn` returned false.
Simplified simplified(const MeshPtr& mesh, float bound, const std::function<bool()>& goesOn);

/// Returns a mesh of fewer triangles as `simplified` first tries it: its vertices are off by
/// `tolerance` (mm, root mean square) at most from the planes they stand for, but how far it lies
/// off in all is not looked at, so it is several times as quick. It is the same mesh where no
/// triangle could be removed or `goesOn` returned false.
MeshPtr collapsed(const MeshPtr& mesh, float tolerance, const std::function<bool()>& goesOn);
/// Returns the largest distance of either surface from the other, mm, as `simplified` measures it.
float deviation(const MeshPtr& mesh, const MeshPtr& original);

/// Returns the largest distance of samples of `mesh`, `spacing` mm apart, from the surface of
/// `from`; infinite where that is empty and the mesh is not.
float farthestSample(const Mesh& mesh, const Bvh& from, float spacing);

}  // namespace sline::model
