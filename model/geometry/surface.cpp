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
/// The median over the vertices of the smaller radius of curvature.
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
}  // namespace

SurfacePtr prepareSurface(MeshPtr mesh, const CurvatureOptions& options) {
  auto surface = std::make_shared<Surface>();
  {
    const VertexFaces faces(*mesh);
    surface->normals = vertexNormals(*mesh, faces);
    surface->curvature = curvature(*mesh, surface->normals, faces, options);
    surface->closed = mesh->triangleCount() > 0 && countEdges(*mesh, faces).closed();
  }
  surface->clusters =
      buildClusters(*mesh, spatialOrder(*mesh), surface->normals, surface->curvature);
  surface->boundingSphere = smallestBoundingSphere(mesh->positions());
  surface->featureSize = surface->boundingSphere.radius;
  surface->filigreeSize = std::min(surface->featureSize, medianRadius(surface->curvature.k));
  surface->meanEdge = meanEdgeLength(mesh->positions(), mesh->triangles());
  surface->mesh = std::move(mesh);
  return surface;
}

}  // namespace sline::model
