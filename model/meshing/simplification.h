// SPDX-License-Identifier: Apache-2.0
// As few triangles as an error bound allows.
#pragma once

#include <functional>

#include "model/geometry/bvh.h"
#include "model/geometry/mesh.h"

namespace sline::model {

struct Simplified {
  MeshPtr mesh;
  float error = 0.0f;  ///< the farthest either surface lies from the other, mm, as measured
};

/// A mesh of fewer triangles of which no sample lies farther than `bound` (mm, > 0) from the
/// original, nor a sample of the original from it: samples are the vertices and points of a grid on
/// each triangle that lie as close as the original's edges are long, or a sixth of the triangle's
/// own. The bound is measured, not estimated: where a first result breaks it, that place
/// is made finer.
/// Closed stays closed, each edge keeps its number of triangles and each piece its handles; rims
/// and edges of three triangles or more stay as they are. The same mesh, error 0, where nothing
/// could be taken away or `goesOn` said no.
Simplified simplified(const MeshPtr& mesh, float bound, const std::function<bool()>& goesOn);

/// How far samples of `mesh`, `spacing` mm apart, lie from the surface of `from` at most; infinite
/// where that is empty and the mesh is not.
float farthestSample(const Mesh& mesh, const Bvh& from, float spacing);

}  // namespace sline::model
