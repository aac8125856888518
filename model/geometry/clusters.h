// SPDX-License-Identifier: Apache-2.0
// Cuts a surface into runs of neighbouring triangles with bounds on position, normal and curvature,
// so that a view can skip most of the surface without looking at its triangles (METHOD §10).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/geometry/curvature.h"
#include "model/geometry/mesh.h"

namespace sline::model {

struct Cluster {
  std::uint32_t firstTriangle = 0;  ///< index into Clusters::triangles
  std::uint32_t triangleCount = 0;
  std::uint32_t firstVertex = 0;  ///< index into Clusters::vertices
  std::uint32_t vertexCount = 0;
  Sphere bounds;
  glm::vec3 coneAxis{0.0f};      ///< mean direction of its normals
  float coneCosine = -1.0f;      ///< smallest cosine between the axis and any vertex or face normal
  float lowestCurvature = 0.0f;  ///< of both principal curvatures over its vertices
  float highestCurvature = 0.0f;
};

/// Holds the values that line extraction reads for every vertex of a cluster in every view, copied
/// into cluster order as a structure of arrays (index: Clusters::vertices), so that the loop over
/// them runs on whole vector registers without gathering. `s` is the shape operator as a symmetric
/// matrix in space (xx, xy, xz, yy, yz, zz; 1/mm): since S·n = 0, κr·|w|² = dᵀ·S·d / |d|² for any
/// vector d to the eye.
struct ClusterVertices {
  std::array<std::vector<float>, 3> position;
  std::array<std::vector<float>, 3> normal;
  std::array<std::vector<float>, 6> s;
};

struct Clusters {
  static constexpr std::uint32_t maximumTriangles = 128;
  static constexpr std::uint32_t maximumVertices = 255;

  std::vector<Cluster> items;
  std::vector<std::uint32_t> triangles;  ///< the mesh's triangle in each slot, in spatial order
  std::vector<std::uint32_t> vertices;   ///< the mesh's vertices of each cluster, each once
  /// For each slot, the indices into its cluster's vertices.
  std::vector<std::array<std::uint8_t, 3>> localTriangles;
  ClusterVertices fields;
};

/// Cuts `order` (see spatialOrder) into clusters; normals and curvature are per vertex of the mesh.
Clusters buildClusters(const Mesh& mesh, std::vector<std::uint32_t> order,
                       std::span<const glm::vec3> normals, const Curvature& curvature);

/// Says how a cluster faces a viewpoint, as far as its bounds alone tell.
enum class Facing { front, back, mixed };
/// `eye` is a position or, for a parallel projection, the unit direction towards the eye.
struct EyePoint {
  glm::vec3 value;
  bool atInfinity = false;
};
Facing facing(const Cluster& cluster, const EyePoint& eye);

}  // namespace sline::model
