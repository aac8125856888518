// SPDX-License-Identifier: Apache-2.0
#include "render/picture/sample_levels.h"

#include <algorithm>
#include <utility>

#include "model/geometry/cluster_order.h"
#include "model/geometry/coarsening.h"
#include "model/geometry/edge_length.h"

namespace sline::render {

namespace {

std::vector<model::Triangle> trianglesOf(const model::Clusters& clusters) {
  std::vector<model::Triangle> triangles;
  triangles.reserve(clusters.localTriangles.size());
  for (const model::Cluster& cluster : clusters.items) {
    const std::uint32_t* vertices = clusters.vertices.data() + cluster.firstVertex;
    for (std::uint32_t i = 0; i < cluster.triangleCount; ++i) {
      const auto [a, b, c] = clusters.localTriangles[cluster.firstTriangle + i];
      triangles.push_back({vertices[a], vertices[b], vertices[c]});
    }
  }
  return triangles;
}

/// Returns a mesh of all the surface's vertices with these triangles between them.
model::Mesh meshOf(const model::Surface& surface, std::vector<model::Triangle> triangles) {
  const auto positions = surface.mesh->positions();
  Result<model::Mesh> made =
      model::Mesh::create({positions.begin(), positions.end()}, std::move(triangles));
  return std::move(*made);
}

}  // namespace

void SampleLevels::add(const model::Surface& surface) {
  const auto coarser = [](const model::Mesh& mesh, float edge) {
    return model::coarsenedTriangles(mesh, LevelStep::collapsed * edge);
  };
  const std::size_t before = m_levels.empty() ? surface.mesh->triangleCount()
                                              : m_levels.back()->clusters.localTriangles.size();
  m_complete = before < leastTriangles;
  if (m_complete)
    return;
  std::vector<model::Triangle> triangles =
      m_levels.empty()
          ? coarser(*surface.mesh, surface.meanEdge)
          : coarser(meshOf(surface, trianglesOf(m_levels.back()->clusters)), m_levels.back()->edge);
  m_complete = !(float(triangles.size()) < LevelStep::worthwhile * float(before));
  if (m_complete)
    return;
  const float edge = model::meanEdgeLength(surface.mesh->positions(), triangles);
  const model::Mesh mesh = meshOf(surface, std::move(triangles));
  auto level = std::make_unique<Level>();
  level->edge = edge;
  level->clusters = model::buildClusters(mesh, model::clusterOrder(mesh), surface.vertices.all());
  level->clusters.triangles = {};
  level->clusters.samples = {};
  level->clusters.groups = {};
  m_levels.push_back(std::move(level));
}

const model::Clusters* SampleLevels::at(const model::Surface& surface, const Coarseness& allowed) {
  const auto finest = [&] { return m_levels.empty() ? surface.meanEdge : m_levels.back()->edge; };
  while (!allowed.hurried && !m_complete && LevelStep::growth * finest() <= allowed.edge)
    add(surface);
  const auto tooCoarse =
      std::find_if(m_levels.begin(), m_levels.end(),
                   [&](const std::unique_ptr<Level>& level) { return level->edge > allowed.edge; });
  return tooCoarse == m_levels.begin() ? nullptr : &(*std::prev(tooCoarse))->clusters;
}

}  // namespace sline::render
