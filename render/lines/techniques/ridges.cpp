// SPDX-License-Identifier: Apache-2.0
#include "render/lines/techniques/ridges.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "render/lines/techniques/crest_lines.h"
#include "render/lines/techniques/fixed_lines.h"

namespace sline::render {

namespace {

/// Returns |κ1''|/|κ1|³ across a crest in the triangle: how fast the rises of two corners on either
/// side of it change over the way between them.
float sharpnessOf(const CrestTriangle& triangle, float curvature) {
  float sharpest = 0.0f;
  for (std::size_t i = 0; i < 3; ++i) {
    const CrestCorner& a = triangle.corners[i];
    const CrestCorner& b = triangle.corners[(i + 1) % 3];
    const glm::vec3 edge = b.position - a.position;
    // An edge that hardly crosses the line tells nothing of what lies beside it.
    const float way = std::max(std::abs(glm::dot(edge, a.axis)), 0.5f * glm::length(edge));
    if (glm::dot(a.rise, b.rise) < 0.0f && way > 0.0f)
      sharpest = std::max(sharpest, glm::length(b.rise - a.rise) / way);
  }
  return sharpest / (curvature * curvature * curvature);
}

/// Returns for each vertex the direction in which κ1 rises along its own line, times how fast it
/// does so. Third derivatives are rough, so it is the mean over the neighbours, three times: a
/// crest, to whose sides it is opposite, stays where it is.
std::vector<glm::vec3> rises(const model::Surface& surface) {
  const model::CurvatureColumns& curvature = surface.curvature;
  std::vector<glm::vec3> rise(curvature.e1.size());
  for (std::size_t v = 0; v < rise.size(); ++v)
    rise[v] = curvature.derivative[v].x * curvature.e1[v];
  constexpr int rounds = 3;
  std::vector<glm::vec3> sum;
  std::vector<float> count;
  for (int round = 0; round < rounds; ++round) {
    sum = rise;
    count.assign(rise.size(), 1.0f);
    for (const model::Triangle& t : surface.mesh->triangles())
      for (std::size_t i = 0; i < 3; ++i) {
        sum[t[i]] += rise[t[(i + 1) % 3]];
        count[t[i]] += 1.0f;
      }
    for (std::size_t v = 0; v < rise.size(); ++v) {
      const glm::vec3& e1 = curvature.e1[v];
      rise[v] = glm::dot(sum[v], e1) / count[v] * e1;
    }
  }
  return rise;
}

/// Finds the crests of `sign`·κ1 where it is positive.
std::unique_ptr<const PreparedLines> prepareCrests(const model::Surface& surface, float sign) {
  const auto triangles = surface.mesh->triangles();
  const auto positions = surface.mesh->positions();
  const model::CurvatureColumns& curvature = surface.curvature;
  const std::vector<glm::vec3> rise = rises(surface);
  return std::make_unique<FixedLines>(
      fixedLines(triangles.size(), [&](std::uint32_t i, std::vector<FixedLine>& lines) {
        CrestTriangle triangle{.triangle = i, .corners = {}};
        float mean = 0.0f;
        for (std::size_t c = 0; c < 3; ++c) {
          const std::uint32_t v = triangles[i][c];
          const float k = sign * curvature.k[v].x;
          if (!(k > 0.0f))
            return;
          mean += k / 3.0f;
          triangle.corners[c] = {.position = positions[v],
                                 .normal = surface.normals[v],
                                 .axis = curvature.e1[v],
                                 .rise = sign * rise[v],
                                 .strength = k * surface.featureSize};
        }
        const auto crests = crestsIn(triangle);
        if (crests.empty())
          return;
        const float sharpness = sharpnessOf(triangle, mean);
        for (const std::array<LineEnd, 2>& ends : crests)
          lines.push_back({.ends = ends, .triangle = i, .sharpness = sharpness});
      }));
}

void findCrests(const LineSearch& search, LineKind kind, std::vector<Segment>& segments) {
  const LineThresholds& thresholds = search.request.thresholds;
  static_cast<const FixedLines*>(search.prepared)
      ->find(
          search,
          {.least = thresholds.of(kind, leastRidgeCurvature), .twoSided = search.request.twoSided},
          thresholds.of(kind, leastRidgeSharpness), segments);
}

}  // namespace

std::unique_ptr<const PreparedLines> prepareRidges(const model::Surface& surface) {
  return prepareCrests(surface, 1.0f);
}

std::unique_ptr<const PreparedLines> prepareValleys(const model::Surface& surface) {
  return prepareCrests(surface, -1.0f);
}

void findRidges(const LineSearch& search, std::vector<Segment>& segments) {
  findCrests(search, LineKind::ridge, segments);
}

void findValleys(const LineSearch& search, std::vector<Segment>& segments) {
  findCrests(search, LineKind::valley, segments);
}

}  // namespace sline::render
