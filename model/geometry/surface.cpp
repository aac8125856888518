// SPDX-License-Identifier: Apache-2.0
#include "model/geometry/surface.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "model/geometry/bounding_sphere.h"
#include "model/geometry/edge_length.h"
#include "model/geometry/normals.h"
#include "model/geometry/spatial_order.h"
#include "model/geometry/topology.h"

namespace sline::model {

namespace {
/// Returns the median over the vertices of the smaller radius of curvature.
float medianRadius(std::span<const glm::vec2> curvatures) {
  if (curvatures.empty())
    return 0.0f;
  std::vector<float> largest(curvatures.size());
  std::transform(curvatures.begin(), curvatures.end(), largest.begin(),
                 [](const glm::vec2& k) { return std::max(std::abs(k.x), std::abs(k.y)); });
  const auto middle = largest.begin() + std::ptrdiff_t(largest.size() / 2);
  std::nth_element(largest.begin(), middle, largest.end());
  return 1.0f / *middle;
}

/// The rims of holes may be this long together, in units of F, before a surface counts as a sheet.
/// The worst of 40 muscles and vessels drawn as solids has 0.3; an open tube as long as it is wide
/// has 4.
constexpr float longestRim = 0.5f;
}  // namespace

SurfacePtr prepareSurface(MeshPtr mesh, const CurvatureOptions& options) {
  auto surface = std::make_shared<Surface>();
  double rims = 0.0;
  {
    const VertexFaces faces(*mesh);
    surface->normals = vertexNormals(*mesh, faces);
    surface->curvature = curvature(*mesh, surface->normals, faces, options);
    surface->closed = mesh->triangleCount() > 0 && countEdges(*mesh, faces).closed();
    rims = surface->closed ? 0.0 : rimLength(*mesh, faces);
  }
  surface->clusters =
      buildClusters(*mesh, spatialOrder(*mesh), surface->normals, surface->curvature);
  surface->boundingSphere = smallestBoundingSphere(mesh->positions());
  surface->featureSize = surface->boundingSphere.radius;
  surface->solid = mesh->triangleCount() > 0 && float(rims) <= longestRim * surface->featureSize;
  surface->filigreeSize = std::min(surface->featureSize, medianRadius(surface->curvature.k));
  surface->meanEdge = meanEdgeLength(mesh->positions(), mesh->triangles());
  surface->mesh = std::move(mesh);
  return surface;
}

SurfacePtr reshapedSurface(const Surface& surface, const Mesh& shape) {
  auto reshaped = std::make_shared<Surface>(surface);
  const VertexFaces faces(shape);
  reshaped->normals = vertexNormals(shape, faces);
  reshaped->curvature = curvature(shape, reshaped->normals, faces);
  reshaped->clusters = buildClusters(*surface.mesh, spatialOrder(*surface.mesh), reshaped->normals,
                                     reshaped->curvature);
  return reshaped;
}

}  // namespace sline::model
