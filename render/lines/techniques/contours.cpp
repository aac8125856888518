// SPDX-License-Identifier: Apache-2.0
#include "render/lines/techniques/contours.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "render/lines/ground/coarse_depth.h"
#include "render/lines/ground/stage_entry.h"
#include "render/lines/ground/view_scale.h"
#include "render/lines/techniques/facing_signs.h"

namespace sline::render {

namespace {

/// Returns whether nv falls towards the eye within the triangle: κr < 0 as this very line sees it,
/// without the noise of the estimated tensor.
bool risesAwayFromEye(const ClusterWalk& walk, const ClusterWalk::Local& local) {
  const glm::vec3 p = walk.shapeAt(local[0]).position;
  const glm::vec3 e1 = walk.shapeAt(local[1]).position - p;
  const glm::vec3 e2 = walk.shapeAt(local[2]).position - p;
  const glm::vec3 normal = glm::cross(e1, e2);
  const float nv0 = walk.nvAt(local[0]);
  const float d1 = walk.nvAt(local[1]) - nv0;
  const float d2 = walk.nvAt(local[2]) - nv0;
  // The gradient of a linear function over a triangle, times the (positive) squared normal.
  const glm::vec3 gradient = d1 * glm::cross(e2, normal) + d2 * glm::cross(normal, e1);
  return glm::dot(gradient, directionTo(walk.eye(), p)) < 0.0f;
}

}  // namespace

bool contoursMayPass(const model::Cluster&, model::Facing facing, const model::EyePoint&) {
  return facing == model::Facing::mixed;
}

void extractContours(const ClusterWalk& walk, const LineRequest& request,
                     std::vector<Segment>& segments) {
  FacingSigns signs;
  if (!signs.find(walk))
    return;
  const auto nvAt = [&walk](std::uint8_t vertex) { return walk.nvAt(vertex); };
  const std::span<const Signs::Crossed> all = signs.crossed(walk);
  for (const Signs::Crossed& crossed : all)
    for (const std::uint8_t corner : walk.local(crossed.triangle))
      walk.fetch(corner);
  for (const Signs::Crossed& crossed : all) {
    const ClusterWalk::Local& local = walk.local(crossed.triangle);
    const bool concave = risesAwayFromEye(walk, local);
    if (concave && !request.hiddenContours)
      continue;
    const std::array<Crossing, 2> c = walk.ends(local, crossed.odd, nvAt);
    segments.push_back({.a = c[0].position,
                        .b = c[1].position,
                        .normalA = glm::normalize(c[0].normal),
                        .normalB = glm::normalize(c[1].normal),
                        .triangle = walk.triangle(crossed.triangle),
                        .concave = concave});
  }
}

void rankContours(std::vector<Segment>& contours, const model::Surface& surface,
                  const model::Camera& camera, float t) {
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
