// SPDX-License-Identifier: Apache-2.0
#include "render/picture/surfaces/sample_levels.h"

#include <algorithm>
#include <utility>

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
          : coarser(model::meshBetween(surface, trianglesOf(m_levels.back()->clusters)),
                    m_levels.back()->edge);
  m_complete = !(float(triangles.size()) < LevelStep::worthwhile * float(before));
  if (m_complete)
    return;
  const float edge = model::meanEdgeLength(surface.mesh->positions(), triangles);
  auto level = std::make_unique<Level>();
  level->edge = edge;
  level->clusters = model::clustersBetween(surface, std::move(triangles));
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
