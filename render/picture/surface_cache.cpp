// SPDX-License-Identifier: Apache-2.0
#include "render/picture/surface_cache.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <set>

namespace sline::render {

namespace {

std::unique_ptr<passes::SurfaceGeometry> upload(const model::Surface& surface) {
  const auto positions = surface.mesh->positions();
  std::vector<passes::SurfaceVertex> vertices(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i)
    vertices[i] = {positions[i], passes::packedNormal(surface.normals[i])};
  return std::make_unique<passes::SurfaceGeometry>(vertices, "surface");
}

}  // namespace

void CachedSurface::needShape() {
  if (geometry->hasShape())
    return;
  const model::Curvature& curvature = surface->curvature;
  std::vector<passes::PackedShape> shape(surface->normals.size());
  for (std::size_t i = 0; i < shape.size(); ++i) {
    const glm::vec3 e1 = curvature.e1[i];
    const glm::vec3 e2 = glm::cross(surface->normals[i], e1);
    const glm::vec2 k = surface->filigreeSize * curvature.k[i];
    shape[i] =
        passes::packedShape(k.x * glm::outerProduct(e1, e1) + k.y * glm::outerProduct(e2, e2));
  }
  geometry->addShape(shape);
}

void CachedSurface::showGammaOffsets(const GammaOffsetsPtr& offsets) {
  if (m_shownOffsets == offsets)
    return;
  geometry->setGammaOffsets(*offsets);
  m_shownOffsets = offsets;
}

void CachedSurface::needWhole() {
  if (geometry->hasWhole())
    return;
  std::vector<std::uint32_t> indices;
  indices.reserve(3 * surface->clusters.triangles.size());
  for (const std::uint32_t triangle : surface->clusters.triangles)
    for (const std::uint32_t vertex : surface->mesh->triangles()[triangle])
      indices.push_back(vertex);
  geometry->addWhole(indices);
}

CachedSurface& SurfaceCache::at(const model::MeshPtr& mesh, const model::Provenance& provenance) {
  CachedSurface& cached = m_surfaces[mesh];
  if (!cached.surface) {
    cached.take(mesh, provenance);
    cached.geometry = upload(*cached.surface);
  }
  return cached;
}

void SurfaceCache::keepOnly(std::span<const model::MeshPtr> meshes) {
  const std::set<model::MeshPtr> kept(meshes.begin(), meshes.end());
  std::erase_if(m_surfaces, [&](const auto& entry) { return !kept.contains(entry.first); });
}

}  // namespace sline::render
