// SPDX-License-Identifier: Apache-2.0
// Computes the values that are needed once per mesh (METHOD §2) and then only read: line extraction
// and drawing start from them.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "model/geometry/clusters.h"
#include "model/geometry/curvature.h"
#include "model/geometry/mesh.h"
#include "model/geometry/surface_vertices.h"

namespace sline::model {

struct Surface {
  Surface() = default;
  Surface(const Surface&) = delete;
  Surface& operator=(const Surface&) = delete;

  MeshPtr mesh;
  SurfaceVertices vertices;
  NormalColumn normals;        ///< of the vertices
  CurvatureColumns curvature;  ///< of the vertices
  Clusters clusters;
  Sphere boundingSphere;
  float featureSize = 0.0f;   ///< F: radius of the bounding sphere, mm
  float filigreeSize = 0.0f;  ///< F_c = min(F, median of 1/max(|κ1|, |κ2|)), mm (METHOD §1)
  float meanEdge = 0.0f;      ///< mm
  bool closed = false;        ///< every edge has two triangles
  /// True for a surface that is closed but for specks: the rims of its holes are shorter than F/2
  /// together. Its section is filled (METHOD §7).
  bool solid = false;
};
using SurfacePtr = std::shared_ptr<const Surface>;

/// Tells whether the mesh's surface is `Surface::solid`, without making it.
bool isSolid(const Mesh& mesh);

SurfacePtr prepareSurface(MeshPtr mesh, const CurvatureOptions& options = {});

/// A mesh, and some of its vertices: those of a coarser one that stands for it.
struct FinerMesh {
  MeshPtr mesh;
  std::vector<std::uint32_t> vertices;
};

/// Returns the surface of a coarser mesh, with normals and curvature of the finer one.
SurfacePtr prepareCoarser(MeshPtr mesh, const FinerMesh& finer,
                          const CurvatureOptions& options = {});
/// Does so where the finer surface is at hand, of which these are the vertices.
SurfacePtr prepareCoarser(MeshPtr mesh, const Surface& finer,
                          std::span<const std::uint32_t> vertices);

/// Returns the surface with normals and curvature of `shape`, a mesh of the same triangles; all
/// else, positions too, stays its own.
SurfacePtr reshapedSurface(const Surface& surface, const Mesh& shape);
/// Does so with a mesh of finer triangles, of which these are the surface's vertices.
SurfacePtr reshapedSurface(const Surface& surface, const Mesh& shape,
                           std::span<const std::uint32_t> vertices);

}  // namespace sline::model
