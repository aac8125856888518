// SPDX-License-Identifier: Apache-2.0
#include "render/lines/techniques/apparent_ridges.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>
#include <glm/matrix.hpp>

#include "model/base/parallel.h"
#include "render/lines/ground/headlight.h"
#include "render/lines/techniques/crest_lines.h"

namespace sline::render {

namespace {

/// What a view makes of a vertex.
struct Apparent {
  float nv = 0.0f;
  float q1 = 0.0f;
  glm::vec3 along{0.0f};     ///< see ApparentCurvature
  glm::vec3 gradient{0.0f};  ///< of q1 over the surface, the mean of the triangles around
  float area = 0.0f;         ///< of these, twice
};

Apparent apparentAt(const model::Surface& surface, std::uint32_t v, const model::EyePoint& eye) {
  const glm::vec3& e1 = surface.curvature.e1[v];
  const glm::vec3& n = surface.normals[v];
  const glm::vec3 view = directionTo(eye, surface.mesh->positions()[v]);
  const float nv = glm::dot(n, view);
  const ApparentCurvature found = apparentCurvature(
      surface.curvature.k[v], {glm::dot(view, e1), glm::dot(view, glm::cross(n, e1))}, nv);
  return {.nv = nv, .q1 = found.q1, .along = inSpace(surface, v, found.along)};
}

/// Adds to each vertex the gradients of q1 in the triangles around it, weighted by their areas.
void addGradients(const model::Mesh& mesh, std::vector<Apparent>& seen) {
  const auto positions = mesh.positions();
  for (const model::Triangle& t : mesh.triangles()) {
    const glm::vec3 u = positions[t[1]] - positions[t[0]];
    const glm::vec3 v = positions[t[2]] - positions[t[0]];
    const glm::vec3 n = glm::cross(u, v);
    const float area = glm::length(n);
    if (!(area > 0.0f))
      continue;
    const glm::vec3 gradient = ((seen[t[1]].q1 - seen[t[0]].q1) * glm::cross(v, n) +
                                (seen[t[2]].q1 - seen[t[0]].q1) * glm::cross(n, u)) /
                               area;
    for (const std::uint32_t corner : t) {
      seen[corner].gradient += gradient;
      seen[corner].area += area;
    }
  }
}

}  // namespace

ApparentCurvature apparentCurvature(const glm::vec2& k, const glm::vec2& w, float nv) {
  constexpr float leastCosine = 0.01f;
  const float length = glm::length(w);
  const glm::vec2 u = length > 0.0f ? w / length : glm::vec2(0.0f);
  const float stretch = 1.0f / std::max(std::abs(nv), leastCosine) - 1.0f;
  const glm::mat2 toSurface = glm::mat2(1.0f) + stretch * glm::outerProduct(u, u);
  const glm::mat2 q = glm::mat2(k.x, 0.0f, 0.0f, k.y) * toSurface;
  const glm::mat2 square = glm::transpose(q) * q;
  const float half = 0.5f * (square[0][0] - square[1][1]);
  const float mixed = square[0][1];
  const float radius = std::sqrt(half * half + mixed * mixed);
  const float greater = 0.5f * (square[0][0] + square[1][1]) + radius;
  // Of the two forms of the eigenvector the one without cancellation.
  glm::vec2 t1 = half >= 0.0f ? glm::vec2(half + radius, mixed) : glm::vec2(mixed, radius - half);
  const float size = glm::length(t1);
  t1 = size > 0.0f ? t1 / size : glm::vec2(1.0f, 0.0f);
  return {.q1 = std::sqrt(std::max(greater, 0.0f)), .along = toSurface * t1};
}

void findApparentRidges(const LineSearch& search, std::vector<Segment>& segments) {
  const model::Surface& surface = search.surface;
  const auto positions = surface.mesh->positions();
  const auto triangles = surface.mesh->triangles();
  const model::EyePoint eye = eyeOf(search.camera);
  std::vector<Apparent> seen(positions.size());
  parallelFor(seen.size(), 1024,
              [&](std::size_t v) { seen[v] = apparentAt(surface, std::uint32_t(v), eye); });
  addGradients(*surface.mesh, seen);
  const LineClip clip{
      .least = search.request.thresholds.of(LineKind::apparentRidge, leastApparentCurvature),
      .twoSided = search.request.twoSided};
  constexpr std::size_t perChunk = 4096;
  std::vector<std::vector<Segment>> chunks((triangles.size() + perChunk - 1) / perChunk);
  parallelFor(chunks.size(), 1, [&](std::size_t chunk) {
    const std::size_t end = std::min(triangles.size(), (chunk + 1) * perChunk);
    for (std::size_t i = chunk * perChunk; i < end; ++i) {
      CrestTriangle triangle{.triangle = std::uint32_t(i), .corners = {}};
      bool any = false;
      for (std::size_t c = 0; c < 3; ++c) {
        const std::uint32_t v = triangles[i][c];
        const Apparent& at = seen[v];
        const float length = glm::length(at.along);
        const glm::vec3 axis = length > 0.0f ? at.along / length : at.along;
        const float slope = glm::dot(at.gradient, at.along) / std::max(at.area, 1e-20f);
        triangle.corners[c] = {.position = positions[v],
                               .normal = surface.normals[v],
                               .nv = at.nv,
                               .axis = axis,
                               .rise = slope * axis,
                               .strength = at.q1 * surface.featureSize};
        any = any || (triangle.corners[c].strength > clip.least && (clip.twoSided || at.nv > 0.0f));
      }
      if (any)
        appendCrests(triangle, clip, chunks[chunk]);
    }
  });
  for (const std::vector<Segment>& chunk : chunks)
    segments.insert(segments.end(), chunk.begin(), chunk.end());
}

}  // namespace sline::render
