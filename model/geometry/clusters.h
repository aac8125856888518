// SPDX-License-Identifier: Apache-2.0
// Cuts a surface into runs of neighbouring triangles that face alike, with bounds on position,
// normal and curvature, so that a view can skip most of the surface without looking at its
// triangles (METHOD §10).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "model/geometry/mesh.h"
#include "model/geometry/surface_vertices.h"

namespace sline::model {

/// Bounds the shape operators of some vertices: symmetric matrices in space (xx, xy, xz, yy, yz,
/// zz; 1/mm). Since S·n = 0, κr·|w|² = dᵀ·S·d / |d|² for any vector d to the eye.
struct TensorBounds {
  std::array<float, 6> middle{};
  float spread = 0.0f;   ///< no S differs from the middle by more (Frobenius norm)
  float largest = 0.0f;  ///< largest |κ|
  float step = 0.0f;     ///< of Clusters::samples
};

/// Bounds directions of normals.
struct NormalCone {
  glm::vec3 axis{0.0f};
  float cosine = -1.0f;  ///< the smallest between the axis and any of them
};

/// A run of triangles; or a group of clusters, of which only what bounds it is known, and how many
/// triangles and candidates it has.
struct Cluster {
  std::uint32_t firstTriangle = 0;  ///< index into Clusters::triangles
  std::uint32_t triangleCount = 0;
  std::uint32_t firstVertex = 0;  ///< index into Clusters::vertices
  std::uint32_t vertexCount = 0;
  /// The first of its triangles, and of its vertices those that they use: the triangles whose
  /// corners are neither all convex nor all concave. In others κr has one sign from every eye.
  std::uint32_t candidateTriangles = 0;
  std::uint32_t candidateVertices = 0;
  std::uint32_t firstSample = 0;  ///< index into Clusters::samples
  Sphere bounds;
  NormalCone cone;            ///< of its vertex and face normals
  float normalStep = 0.0f;    ///< of Clusters::samples
  TensorBounds tensorBounds;  ///< of its candidate vertices
};

struct Clusters {
  static constexpr std::uint32_t maximumTriangles = 64;
  static constexpr std::uint32_t maximumVertices = 3 * maximumTriangles;

  std::vector<Cluster> items;
  std::vector<std::uint32_t> triangles;  ///< the mesh's triangle in each slot, cluster by cluster
  std::vector<std::uint32_t> vertices;   ///< the mesh's vertices of each cluster, each once
  /// For each slot, the indices into its cluster's vertices.
  std::vector<std::array<std::uint8_t, 3>> localTriangles;
  static constexpr std::size_t placeRows = 6;
  static constexpr std::size_t bendingRows = 6;
  static constexpr float mostSteps = 127.0f;  ///< also the number that stands for none
  /// For each cluster six rows of a number for each of its vertices, from which signs of nv are
  /// found without looking at the mesh: how its position differs from the centre of the bounds, in
  /// steps of radius / 127, and its normal from the cone's axis, in the cluster's steps; then six
  /// rows for each of its candidate vertices, from which signs of κr are found: how S differs from
  /// the middle, in steps of the tensor bounds. All are rounded to the nearest step.
  std::vector<std::uint8_t> samples;
  static constexpr std::size_t cornerRows = 6;
  /// For each cluster six rows of a number for each of its vertices: positions and normals, so that
  /// nobody has to look for them all over the mesh. Only coarser forms have them.
  std::vector<float> corners;
  /// Returns a row of the cluster's `corners`; null: there are none.
  const float* cornerRow(const Cluster& cluster, std::size_t row) const {
    return corners.empty()
               ? nullptr
               : corners.data() + cornerRows * cluster.firstVertex + row * cluster.vertexCount;
  }

  /// For so many items in a row, what bounds all of them, so that a view can skip them together.
  static constexpr std::size_t itemsOfGroup = 64;
  std::vector<Cluster> groups;
};

/// Cuts `order` (see clusterOrder) into clusters; `vertices` are those of the mesh.
Clusters buildClusters(const Mesh& mesh, std::vector<std::uint32_t> order,
                       std::span<const SurfaceVertex> vertices);

/// Says how a part of a surface faces a viewpoint, as far as its bounds alone tell.
enum class Facing { front, back, mixed };
/// `eye` is a position or, for a parallel projection, the unit direction towards the eye.
struct EyePoint {
  glm::vec3 value;
  bool atInfinity = false;
};
Facing facing(const Sphere& bounds, const NormalCone& cone, const EyePoint& eye);
inline Facing facing(const Cluster& cluster, const EyePoint& eye) {
  return facing(cluster.bounds, cluster.cone, eye);
}

}  // namespace sline::model
