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

/// Returns vertices at these positions, with normals and curvature of a mesh of the same triangles.
SurfaceVertices verticesAt(std::span<const glm::vec3> positions, const Mesh& shape,
                           const CurvatureOptions& options) {
  const std::vector<glm::vec3> normals = vertexNormals(shape);
  return {positions, normals, curvature(shape, normals, options)};
}

/// Returns vertices at these positions, with normals and curvature of some of the shape's.
SurfaceVertices someVerticesAt(std::span<const glm::vec3> positions, const Mesh& shape,
                               std::span<const std::uint32_t> vertices,
                               const CurvatureOptions& options) {
  const std::vector<glm::vec3> all = vertexNormals(shape);
  const Curvature known = curvatureAt(vertices, shape, all, options);
  std::vector<glm::vec3> normals(vertices.size());
  std::transform(vertices.begin(), vertices.end(), normals.begin(),
                 [&](std::uint32_t v) { return all[v]; });
  return {positions, normals, known};
}

void setVertices(Surface& surface, SurfaceVertices vertices) {
  surface.vertices = std::move(vertices);
  surface.normals = NormalColumn(surface.vertices.all());
  surface.curvature = {
      .e1 = decltype(CurvatureColumns::e1)(surface.vertices.all()),
      .k = decltype(CurvatureColumns::k)(surface.vertices.all()),
      .derivative = decltype(CurvatureColumns::derivative)(surface.vertices.all())};
}

/// Makes the surface of a mesh. `vertices` returns what is known of them.
template <class Vertices>
SurfacePtr surfaceOf(MeshPtr mesh, const Vertices& vertices) {
  auto surface = std::make_shared<Surface>();
  surface->mesh = std::move(mesh);
  const Mesh& own = *surface->mesh;
  double rims = 0.0;
  setVertices(*surface, vertices());
  {
    const VertexFaces faces(own);
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
}  // namespace

bool isSolid(const Mesh& mesh) {
  if (mesh.triangleCount() == 0)
    return false;
  const VertexFaces faces(mesh);
  return countEdges(mesh, faces).closed() ||
         float(rimLength(mesh, faces)) <=
             longestRim * smallestBoundingSphere(mesh.positions()).radius;
}

SurfacePtr prepareSurface(MeshPtr mesh, const CurvatureOptions& options) {
  const Mesh& own = *mesh;
  return surfaceOf(std::move(mesh), [&] { return verticesAt(own.positions(), own, options); });
}

SurfacePtr prepareCoarser(MeshPtr mesh, const FinerMesh& finer, const CurvatureOptions& options) {
  const Mesh& own = *mesh;
  return surfaceOf(std::move(mesh), [&] {
    return someVerticesAt(own.positions(), *finer.mesh, finer.vertices, options);
  });
}

SurfacePtr prepareCoarser(MeshPtr mesh, const Surface& finer,
                          std::span<const std::uint32_t> vertices) {
  return surfaceOf(std::move(mesh),
                   [&] { return SurfaceVertices(finer.vertices.all(), vertices); });
}

namespace {
SurfacePtr reshaped(const Surface& surface, SurfaceVertices vertices) {
  auto reshaped = std::make_shared<Surface>();
  reshaped->mesh = surface.mesh;
  setVertices(*reshaped, std::move(vertices));
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
}  // namespace

SurfacePtr reshapedSurface(const Surface& surface, const Mesh& shape) {
  return reshaped(surface, verticesAt(surface.mesh->positions(), shape, CurvatureOptions{}));
}

SurfacePtr reshapedSurface(const Surface& surface, const Mesh& shape,
                           std::span<const std::uint32_t> vertices) {
  return reshaped(surface, someVerticesAt(surface.mesh->positions(), shape, vertices, {}));
}

}  // namespace sline::model
