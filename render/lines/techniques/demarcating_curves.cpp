// SPDX-License-Identifier: Apache-2.0
#include "render/lines/techniques/demarcating_curves.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "render/lines/ground/cluster_walk.h"
#include "render/lines/techniques/fixed_lines.h"

namespace sline::render {

namespace {

/// What decides at a vertex whether a curve passes.
struct Steepest {
  glm::vec3 g{0.0f};       ///< in space
  float curvature = 0.0f;  ///< ⟨S·g, g⟩
  float change = 0.0f;     ///< C(g,g,g)
};

Steepest steepestAt(const model::Surface& surface, std::uint32_t v) {
  const glm::vec4& c = surface.curvature.derivative[v];
  const glm::vec2& k = surface.curvature.k[v];
  const glm::vec3& e1 = surface.curvature.e1[v];
  const glm::vec2 g = steepestCurvature(c);
  return {.g = g.x * e1 + g.y * glm::cross(surface.normals[v], e1),
          .curvature = k.x * g.x * g.x + k.y * g.y * g.y,
          .change = c.x * g.x * g.x * g.x + 3.0f * c.y * g.x * g.x * g.y +
                    3.0f * c.z * g.x * g.y * g.y + c.w * g.y * g.y * g.y};
}

}  // namespace

glm::vec2 steepestCurvature(const glm::vec4& derivative) {
  const double a = derivative.x;
  const double b = derivative.y;
  const double c = derivative.z;
  const double d = derivative.w;
  const auto value = [&](double angle) {
    const double x = std::cos(angle);
    const double y = std::sin(angle);
    return a * x * x * x + 3.0 * b * x * x * y + 3.0 * c * x * y * y + d * y * y * y;
  };
  constexpr int samples = 24;
  constexpr double apart = 6.283185307179586 / double(samples);
  const auto refined = [&](double angle) {
    for (int step = 0; step < 8; ++step) {
      const double x = std::cos(angle);
      const double y = std::sin(angle);
      const double slope =
          b * x * x * x + (2.0 * c - a) * x * x * y + (d - 2.0 * b) * x * y * y - c * y * y * y;
      const double bend = -3.0 * b * x * x * y + (2.0 * c - a) * (x * x * x - 2.0 * x * y * y) +
                          (d - 2.0 * b) * (2.0 * x * x * y - y * y * y) - 3.0 * c * x * y * y;
      if (!(bend < 0.0))
        break;
      angle -= std::clamp(slope / bend, -0.5 * apart, 0.5 * apart);
    }
    return angle;
  };
  // C's first and third harmonic may have three maxima nearly as great as each other.
  double best = 0.0;
  for (int i = 0; i < samples; ++i) {
    const double at = apart * double(i);
    if (value(at) < value(at - apart) || value(at) < value(at + apart))
      continue;
    if (const double angle = refined(at); value(angle) > value(best))
      best = angle;
  }
  return {float(std::cos(best)), float(std::sin(best))};
}

std::unique_ptr<const PreparedLines> prepareDemarcatingCurves(const model::Surface& surface) {
  const auto positions = surface.mesh->positions();
  const auto triangles = surface.mesh->triangles();
  std::vector<Steepest> steepest(positions.size());
  parallelFor(steepest.size(), 1024,
              [&](std::size_t v) { steepest[v] = steepestAt(surface, std::uint32_t(v)); });
  const float f2 = surface.featureSize * surface.featureSize;
  const auto endOn = [&](std::uint32_t a, std::uint32_t b) -> LineEnd {
    if (b < a)
      std::swap(a, b);
    const float t = zeroBetween(steepest[a].curvature, steepest[b].curvature);
    const auto mix = [t](const auto& x, const auto& y) { return x + t * (y - x); };
    return {.position = mix(positions[a], positions[b]),
            .normal = mix(surface.normals[a], surface.normals[b]),
            .strength = f2 * mix(steepest[a].change, steepest[b].change)};
  };
  return std::make_unique<FixedLines>(
      fixedLines(triangles.size(), [&](std::uint32_t i, std::vector<FixedLine>& lines) {
        const model::Triangle& t = triangles[i];
        std::array<bool, 3> negative{};
        for (std::size_t c = 0; c < 3; ++c) {
          negative[c] = steepest[t[c]].curvature < 0.0f;
          // Corners that disagree by more than 45° say nothing of what lies between them.
          constexpr float halfRightAngle = 0.70710678f;
          if (glm::dot(steepest[t[c]].g, steepest[t[(c + 1) % 3]].g) < halfRightAngle)
            return;
        }
        if (negative[0] == negative[1] && negative[1] == negative[2])
          return;
        const std::size_t odd = negative[1] == negative[2] ? 0 : negative[0] == negative[2] ? 1 : 2;
        lines.push_back({.ends = {endOn(t[odd], t[(odd + 1) % 3]), endOn(t[odd], t[(odd + 2) % 3])},
                         .triangle = i});
      }));
}

void findDemarcatingCurves(const LineSearch& search, std::vector<Segment>& segments) {
  static_cast<const FixedLines*>(search.prepared)
      ->find(search,
             {.least = search.request.thresholds.of(LineKind::demarcating, leastDemarcatingChange),
              .twoSided = search.request.twoSided},
             0.0f, segments);
}

}  // namespace sline::render
