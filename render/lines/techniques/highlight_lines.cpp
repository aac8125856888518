// SPDX-License-Identifier: Apache-2.0
#include "render/lines/techniques/highlight_lines.h"

#include "render/lines/ground/headlight.h"
#include "render/lines/techniques/crest_lines.h"
#include "render/lines/techniques/zero_lines.h"

namespace sline::render {

void extractSuggestiveHighlights(const ClusterWalk& walk, const LineRequest& request,
                                 std::vector<Segment>& segments) {
  const model::Surface& surface = walk.surface();
  ZeroLines lines(
      walk,
      {.least = request.thresholds.of(LineKind::suggestiveHighlight, leastDarkening),
       .twoSided = request.twoSided,
       .signedStrength = true},
      [&](std::uint32_t vertex) -> ZeroSample {
        const glm::vec3& n = surface.normals[vertex];
        const glm::vec3 v = directionTo(walk.eye(), surface.mesh->positions()[vertex]);
        const glm::vec2 w = viewInPrincipalFrame(n, surface.curvature.e1[vertex], v);
        const glm::vec2& k = surface.curvature.k[vertex];
        return {.value = radialCurvature(k, w),
                .strength = -surface.featureSize * surface.featureSize *
                            radialCurvatureDerivative(k, surface.curvature.derivative[vertex], w,
                                                      glm::dot(n, v))};
      });
  lines.extract(segments);
}

void extractPrincipalHighlights(const ClusterWalk& walk, const LineRequest& request,
                                std::vector<Segment>& segments) {
  const model::Surface& surface = walk.surface();
  const float f2 = surface.featureSize * surface.featureSize;
  const LineClip clip{
      .least = request.thresholds.of(LineKind::principalHighlight, leastHighlightCurvature),
      .twoSided = request.twoSided};
  for (std::uint32_t i = 0; i < walk.cluster().triangleCount; ++i) {
    CrestTriangle triangle{.triangle = walk.triangle(i), .corners = {}};
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint8_t local = walk.local(i)[c];
      const std::uint32_t v = walk.vertex(local);
      const glm::vec3& e1 = surface.curvature.e1[v];
      const float k1 = surface.curvature.k[v].x;
      const float side = walk.nvAt(local) < 0.0f ? -1.0f : 1.0f;
      const glm::vec3 toEye = directionTo(walk.eye(), surface.mesh->positions()[v]);
      triangle.corners[c] = {.position = surface.mesh->positions()[v],
                             .normal = surface.normals[v],
                             .nv = walk.nvAt(local),
                             .axis = e1,
                             .rise = side * k1 * glm::dot(toEye, e1) * e1,
                             .strength = k1 * k1 * f2};
    }
    appendCrests(triangle, clip, segments);
  }
}

}  // namespace sline::render
