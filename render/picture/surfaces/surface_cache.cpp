// SPDX-License-Identifier: Apache-2.0
#include "render/picture/surfaces/surface_cache.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <set>
#include <vector>

#include "model/base/parallel.h"

namespace sline::render {

namespace {

/// Meshes of fewer triangles are prepared several at a time, as they are: they have no other level.
constexpr std::size_t smallMesh = DetailLevels::leastTriangles;
constexpr std::size_t uploadGrain = 8192;

std::unique_ptr<passes::SurfaceGeometry> upload(const model::Surface& surface) {
  const auto positions = surface.mesh->positions();
  const std::vector<std::uint32_t>& places = surface.clusters.vertices;
  std::vector<passes::SurfaceVertex> vertices(places.size());
  parallelFor(places.size(), uploadGrain, [&](std::size_t i) {
    vertices[i] = {positions[places[i]], passes::packedNormal(surface.normals[places[i]])};
  });
  return std::make_unique<passes::SurfaceGeometry>(vertices, "surface");
}

}  // namespace

passes::SurfaceGeometry& CachedSurface::geometry(bool withShape) {
  if (!m_geometry)
    m_geometry = upload(*surface);
  if (!withShape || m_geometry->hasShape())
    return *m_geometry;
  const model::CurvatureColumns& curvature = surface->curvature;
  const std::vector<std::uint32_t>& places = surface->clusters.vertices;
  std::vector<passes::PackedShape> shape(places.size());
  parallelFor(places.size(), uploadGrain, [&](std::size_t i) {
    const std::uint32_t v = places[i];
    const glm::vec3 e1 = curvature.e1[v];
    const glm::vec3 e2 = glm::cross(surface->normals[v], e1);
    const glm::vec2 k = surface->filigreeSize * curvature.k[v];
    shape[i] =
        passes::packedShape(k.x * glm::outerProduct(e1, e1) + k.y * glm::outerProduct(e2, e2));
  });
  m_geometry->addShape(shape);
  return *m_geometry;
}

void CachedSurface::keepWhole() {
  passes::SurfaceGeometry& uploaded = geometry(false);
  if (uploaded.wholeCount() > 0)
    return;
  std::vector<std::uint32_t> indices;
  indices.reserve(3 * surface->clusters.localTriangles.size());
  for (const model::Cluster& cluster : surface->clusters.items)
    for (std::uint32_t i = 0; i < cluster.triangleCount; ++i)
      for (const std::uint8_t corner : surface->clusters.localTriangles[cluster.firstTriangle + i])
        indices.push_back(cluster.firstVertex + corner);
  uploaded.keepWhole(indices);
}

void CachedSurface::showGammaOffsets(const GammaOffsetsPtr& offsets) {
  if (m_shownOffsets == offsets)
    return;
  std::vector<float> placed(surface->clusters.vertices.size());
  std::transform(surface->clusters.vertices.begin(), surface->clusters.vertices.end(),
                 placed.begin(), [&](std::uint32_t v) { return (*offsets)[v]; });
  geometry(false).setGammaOffsets(placed);
  m_shownOffsets = offsets;
}

void SurfaceCache::prepareSmall(std::span<const model::VisibleStructure> structures,
                                const std::atomic<bool>* unwanted) {
  struct Missing {
    DetailLevels* levels;
    const model::Node* node;
  };
  std::map<model::MeshPtr, Missing> missing;
  for (const model::VisibleStructure& structure : structures) {
    const model::Node& node = *structure.node;
    DetailLevels& levels = m_surfaces[node.mesh];
    if (levels.empty() && node.mesh->triangleCount() < smallMesh)
      missing.try_emplace(node.mesh, Missing{&levels, &node});
  }
  std::vector<Missing> each;
  each.reserve(missing.size());
  for (const auto& entry : missing)
    each.push_back(entry.second);
  // The largest first, so that none is left alone at the end.
  std::sort(each.begin(), each.end(), [](const Missing& a, const Missing& b) {
    return a.node->mesh->triangleCount() > b.node->mesh->triangleCount();
  });
  parallelFor(each.size(), 1, [&](std::size_t i) {
    if (!unwanted || !*unwanted)
      each[i].levels->at(each[i].node->mesh, each[i].node->provenance, {});
  });
}

CachedSurface& SurfaceCache::at(const model::MeshPtr& mesh, const model::Provenance& provenance,
                                const Coarseness& allowed) {
  return m_surfaces[mesh].at(mesh, provenance, allowed);
}

void SurfaceCache::keepOnly(std::span<const model::MeshPtr> meshes) {
  const std::set<model::MeshPtr> kept(meshes.begin(), meshes.end());
  std::erase_if(m_surfaces, [&](const auto& entry) { return !kept.contains(entry.first); });
}

}  // namespace sline::render
