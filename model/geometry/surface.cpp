// SPDX-License-Identifier: Apache-2.0
#include "model/geometry/surface.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "model/geometry/bounding_sphere.h"
#include "model/geometry/cluster_order.h"
#include "model/geometry/edge_length.h"
#include "model/geometry/normals.h"
#include "model/geometry/topology.h"

namespace sline::model {

namespace {
/// Returns the median over the vertices of the smaller radius of curvature.
float medianRadius(std::span<const SurfaceVertex> vertices) {
  if (vertices.empty())
    return 0.0f;
  std::vector<float> largest(vertices.size());
  std::transform(vertices.begin(), vertices.end(), largest.begin(),
                 [](const SurfaceVertex& v) { return std::max(std::abs(v.k.x), std::abs(v.k.y)); });
  const auto middle = largest.begin() + std::ptrdiff_t(largest.size() / 2);
  std::nth_element(largest.begin(), middle, largest.end());
  return 1.0f / *middle;
}

/// The rims of holes may be this long together, in units of F, before a surface counts as a sheet.
/// The worst of 40 muscles and vessels drawn as solids has 0.3; an open tube as long as it is wide
/// has 4.
constexpr float longestRim = 0.5f;

/// Sets the vertices: positions of the surface's mesh, normals and curvature of a mesh of the same
/// triangles.
void setVertices(Surface& surface, const Mesh& shape, const VertexFaces& faces,
                 const CurvatureOptions& options) {
  const std::vector<glm::vec3> normals = vertexNormals(shape, faces);
  surface.vertices = SurfaceVertices(surface.mesh->positions(), normals,
                                     curvature(shape, normals, faces, options));
  surface.normals = NormalColumn(surface.vertices.all());
  surface.curvature = {
      .e1 = decltype(CurvatureColumns::e1)(surface.vertices.all()),
      .k = decltype(CurvatureColumns::k)(surface.vertices.all()),
      .derivative = decltype(CurvatureColumns::derivative)(surface.vertices.all())};
}
}  // namespace

SurfacePtr prepareSurface(MeshPtr mesh, const CurvatureOptions& options) {
  auto surface = std::make_shared<Surface>();
  surface->mesh = std::move(mesh);
  const Mesh& own = *surface->mesh;
  double rims = 0.0;
  {
    const VertexFaces faces(own);
    setVertices(*surface, own, faces, options);
    surface->closed = own.triangleCount() > 0 && countEdges(own, faces).closed();
    rims = surface->closed ? 0.0 : rimLength(own, faces);
  }
  surface->clusters = buildClusters(own, clusterOrder(own), surface->vertices.all());
  surface->boundingSphere = smallestBoundingSphere(own.positions());
  surface->featureSize = surface->boundingSphere.radius;
  surface->solid = own.triangleCount() > 0 && float(rims) <= longestRim * surface->featureSize;
  surface->filigreeSize = std::min(surface->featureSize, medianRadius(surface->vertices.all()));
  surface->meanEdge = meanEdgeLength(own.positions(), own.triangles());
  return surface;
}

SurfacePtr reshapedSurface(const Surface& surface, const Mesh& shape) {
  auto reshaped = std::make_shared<Surface>();
  reshaped->mesh = surface.mesh;
  setVertices(*reshaped, shape, VertexFaces(shape), {});
  reshaped->clusters =
      buildClusters(*surface.mesh, surface.clusters.triangles, reshaped->vertices.all());
  reshaped->boundingSphere = surface.boundingSphere;
  reshaped->featureSize = surface.featureSize;
  reshaped->filigreeSize = surface.filigreeSize;
  reshaped->meanEdge = surface.meanEdge;
  reshaped->closed = surface.closed;
  reshaped->solid = surface.solid;
  return reshaped;
}

}  // namespace sline::model
