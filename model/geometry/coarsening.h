// SPDX-License-Identifier: Apache-2.0
// Makes levels of detail of a mesh that is finer than a picture shows.
#pragma once

#include <cstdint>
#include <vector>

#include "model/geometry/mesh.h"
#include "model/geometry/surface.h"

namespace sline::model {

/// A mesh whose vertices are some of a finer one's.
struct CoarserMesh {
  MeshPtr mesh;
  std::vector<std::uint32_t> vertices;  ///< the finer mesh's, one for each of its own
};

/// Returns a mesh of fewer triangles whose vertices are some of the mesh's own, so that what is
/// computed of it is as smooth as before: edges shorter than `edge` (mm, > 0) are collapsed, the
/// shortest of a vertex first, and none comes out longer than 1.8 times that. No vertex that is
/// left out lies farther than a fifth of `edge` from the planes of the triangles in its place; what
/// is sharper, or thin, stays as fine as it is.
/// A closed surface stays closed and keeps its pieces and handles (link condition: Dey,
/// Edelsbrunner, Guha and Nekhayev, "Topology preserving edge contraction", 1999). Rims and
/// vertices around which the triangles are no single fan stay where they are. The same mesh gives
/// the same result whatever the number of threads. The result's mesh is null where nothing was
/// collapsed. It takes about a second per million triangles on one core; `simplified` leaves fewer
/// triangles, of less even sizes, and takes longer.
CoarserMesh coarsened(const Mesh& mesh, float edge);
/// Returns the triangles of that mesh, between the vertices of this one: no fewer than there are
/// where nothing was collapsed.
std::vector<Triangle> coarsenedTriangles(const Mesh& mesh, float edge);

/// Returns a mesh of all the surface's vertices with these triangles between them.
Mesh meshBetween(const Surface& surface, std::vector<Triangle> triangles);
/// Returns the clusters of that mesh as far as drawing needs them: without samples, groups and the
/// triangles' numbers, but with the places and normals of their corners side by side.
Clusters clustersBetween(const Surface& surface, std::vector<Triangle> triangles);

}  // namespace sline::model
