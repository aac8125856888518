// SPDX-License-Identifier: Apache-2.0
#include "model/scalars/mean_curvature.h"

#include <algorithm>
#include <glm/vec2.hpp>

#include "model/base/parallel.h"
#include "model/fairing/half_edges.h"
#include "model/fairing/vertex_rings.h"
#include "model/scalars/ring_diffusion.h"

namespace sline::model {

namespace {
constexpr float averagedSize = 0.02f;  // times F
constexpr int mostSteps = 64;
}  // namespace

std::vector<float> meanCurvature(const Surface& surface) {
  const Mesh& mesh = *surface.mesh;
  std::vector<glm::vec2> field(mesh.vertexCount());
  for (std::size_t v = 0; v < field.size(); ++v) {
    const glm::vec2 k = surface.curvature.k[v];
    field[v].x = 0.5f * (k.x + k.y) * surface.featureSize;
  }
  if (mesh.triangleCount() > 0 && surface.meanEdge > 0.0f) {
    const HalfEdges edges(mesh.vertexCount(), mesh.triangles());
    const VertexRings rings(mesh.vertexCount(), mesh.triangles(), edges);
    const float deviation = averagedSize * surface.featureSize / surface.meanEdge;
    diffuse(rings, int(std::min(4.0f * deviation * deviation, float(mostSteps))), field);
  }
  std::vector<float> values(field.size());
  std::transform(field.begin(), field.end(), values.begin(),
                 [](const glm::vec2& v) { return v.x; });
  return values;
}

}  // namespace sline::model
