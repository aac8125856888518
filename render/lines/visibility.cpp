// SPDX-License-Identifier: Apache-2.0
#include "render/lines/visibility.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "model/base/parallel.h"
#include "render/lines/view_fields.h"

namespace sline::render {

namespace {
/// Contours run where normals, not polygons, turn away: they may lie below the polygons' own edge
/// by a fraction of a triangle. Rays therefore start a little above the surface and overlook what
/// is nearer than one edge of the segment's triangle.
constexpr float liftInEdges = 0.1f;
constexpr float overlookedInEdges = 1.0f;

float longestEdge(const model::Mesh& mesh, std::uint32_t triangle) {
  const auto& [a, b, c] = mesh.triangles()[triangle];
  const auto p = mesh.positions();
  return std::max(
      {glm::distance(p[a], p[b]), glm::distance(p[b], p[c]), glm::distance(p[c], p[a])});
}

/// Calls test(segment index, middle of the segment, unit normal there, edge length) in parallel.
template <class Test>
std::vector<bool> tested(const model::Surface& surface, const std::vector<Segment>& segments,
                         const Test& test) {
  std::vector<char> results(segments.size());
  parallelFor(segments.size(), 64, [&](std::size_t i) {
    const Segment& s = segments[i];
    const glm::vec3 normal = glm::normalize(s.normalA + s.normalB);
    results[i] = test(0.5f * (s.a + s.b), normal, longestEdge(*surface.mesh, s.triangle));
  });
  return {results.begin(), results.end()};
}
}  // namespace

std::vector<bool> visibleSegments(const model::Surface& surface, const model::Bvh& bvh,
                                  const model::Camera& camera,
                                  const std::vector<Segment>& segments) {
  const model::EyePoint eye = eyeOf(camera);
  return tested(surface, segments, [&](const glm::vec3& p, const glm::vec3& n, float edge) {
    const glm::vec3 origin = p + liftInEdges * edge * n;
    const glm::vec3 direction = directionTo(eye, origin);
    const float distance =
        eye.atInfinity ? std::numeric_limits<float>::infinity() : glm::distance(eye.value, origin);
    return !bvh.blocked({.origin = origin,
                         .direction = direction,
                         .nearest = overlookedInEdges * edge,
                         .farthest = distance});
  });
}

std::vector<bool> silhouetteSegments(const model::Surface& surface, const model::Bvh& bvh,
                                     const model::Camera& camera,
                                     const std::vector<Segment>& contours) {
  const model::EyePoint eye = eyeOf(camera);
  return tested(surface, contours, [&](const glm::vec3& p, const glm::vec3& n, float edge) {
    const glm::vec3 beside = p + 2.0f * liftInEdges * edge * n;
    const glm::vec3 direction = directionTo(eye, beside);
    model::Ray ray{.origin = beside, .direction = direction};
    if (eye.atInfinity)
      ray.nearest = -std::numeric_limits<float>::max();
    else
      ray = {.origin = eye.value, .direction = -direction};
    return !bvh.blocked(ray);
  });
}

}  // namespace sline::render
