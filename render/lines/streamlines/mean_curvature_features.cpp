// SPDX-License-Identifier: Apache-2.0
#include "render/lines/streamlines/mean_curvature_features.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "model/base/parallel.h"

namespace sline::render {

namespace {

constexpr std::size_t facesPerTask = 8192;

/// Returns ∇H = ∇tr S / 2 at a vertex, 1/mm².
glm::vec3 meanCurvatureGradient(const model::Surface& surface, std::uint32_t vertex) {
  const glm::vec4& c = surface.curvature.derivative[vertex];
  const glm::vec3& e1 = surface.curvature.e1[vertex];
  const glm::vec3 e2 = glm::cross(surface.normals[vertex], e1);
  return 0.5f * ((c.x + c.z) * e1 + (c.y + c.w) * e2);
}

}  // namespace

std::vector<float> meanCurvatureFeatures(const model::Surface& surface) {
  std::vector<glm::vec3> gradients(surface.normals.size());
  parallelFor(gradients.size(), facesPerTask, [&](std::size_t v) {
    gradients[v] = meanCurvatureGradient(surface, std::uint32_t(v));
  });
  const auto triangles = surface.mesh->triangles();
  std::vector<float> features(triangles.size(), 0.0f);
  parallelFor(triangles.size(), facesPerTask, [&](std::size_t i) {
    const model::Triangle& t = triangles[i];
    const int negative = int(glm::dot(gradients[t[0]], gradients[t[1]]) < 0.0f) +
                         int(glm::dot(gradients[t[1]], gradients[t[2]]) < 0.0f) +
                         int(glm::dot(gradients[t[2]], gradients[t[0]]) < 0.0f);
    if (negative < 2)
      return;
    float sum = 0.0f;
    for (const std::uint32_t vertex : t)
      sum += surface.curvature.k[vertex].x + surface.curvature.k[vertex].y;
    features[i] = std::abs(sum) / 6.0f * surface.filigreeSize;
  });
  return features;
}

}  // namespace sline::render
