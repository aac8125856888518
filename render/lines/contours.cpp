// SPDX-License-Identifier: Apache-2.0
#include "render/lines/contours.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "render/lines/coarse_depth.h"
#include "render/lines/stage_entry.h"
#include "render/lines/view_scale.h"

namespace sline::render {

namespace {

/// Returns whether nv falls towards the eye within the triangle: κr < 0 as this very line sees it,
/// without the noise of the estimated tensor.
bool risesAwayFromEye(const ClusterWalk& walk, const ClusterWalk::Local& local) {
  const auto positions = walk.surface().mesh->positions();
  const glm::vec3 p = positions[walk.vertex(local[0])];
  const glm::vec3 e1 = positions[walk.vertex(local[1])] - p;
  const glm::vec3 e2 = positions[walk.vertex(local[2])] - p;
  const glm::vec3 normal = glm::cross(e1, e2);
  const float nv0 = walk.nvAt(local[0]);
  const float d1 = walk.nvAt(local[1]) - nv0;
  const float d2 = walk.nvAt(local[2]) - nv0;
  // The gradient of a linear function over a triangle, times the (positive) squared normal.
  const glm::vec3 gradient = d1 * glm::cross(e2, normal) + d2 * glm::cross(normal, e1);
  return glm::dot(gradient, directionTo(walk.eye(), p)) < 0.0f;
}

}  // namespace

bool contoursMayPass(const model::Cluster&, model::Facing facing) {
  return facing == model::Facing::mixed;
}

void extractContours(const ClusterWalk& walk, const LineRequest&, std::vector<Segment>& segments) {
  const auto nvAt = [&walk](std::uint8_t vertex) { return walk.nvAt(vertex); };
  for (std::uint32_t i = 0; i < walk.cluster().triangleCount; ++i) {
    const ClusterWalk::Local& local = walk.local(i);
    const std::size_t odd = ClusterWalk::oddCorner(local, walk.facing());
    if (odd == 3)
      continue;
    const std::array<Crossing, 2> c = walk.ends(local, odd, nvAt);
    segments.push_back({.a = c[0].position,
                        .b = c[1].position,
                        .normalA = glm::normalize(c[0].normal),
                        .normalB = glm::normalize(c[1].normal),
                        .triangle = walk.triangle(i),
                        .concave = risesAwayFromEye(walk, local)});
  }
}

void rankContours(std::vector<Segment>& contours, const model::Surface& surface,
                  const model::Camera& camera, float t) {
  if (!needsTwoSides(surface, camera))
    std::erase_if(contours, [](const Segment& s) { return s.concave; });
  if (!(t > 0.0f && t < 1.0f))
    return;
  const ViewScale scale(camera);
  for (Segment& s : contours) {
    s.entryA = scale.project(s.a).distanceMm;
    s.entryB = scale.project(s.b).distanceMm;
  }
  const CoarseDepth depth(surface, camera);
  const auto counts = [&](const Segment& s) {
    const glm::vec3 middle = 0.5f * (s.a + s.b);
    return depth.surrounds(middle, s.normalA) && depth.sees(middle);
  };
  replaceByRank(contours, counts);
}

}  // namespace sline::render
