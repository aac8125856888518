// SPDX-License-Identifier: Apache-2.0
#include "render/lines/techniques/suggestive_contours.h"

#include <algorithm>
#include <cmath>

#include "render/lines/ground/line_clip.h"
#include "render/lines/ground/stage_entry.h"
#include "render/lines/techniques/bending_signs.h"
#include "render/lines/techniques/radial_values.h"

namespace sline::render {

namespace {

/// Returns the least T_SC that has thresholds (S eq. 9) which hold for Dκr·F² and nv.
float entry(float derivative, float nv) {
  constexpr float rightAngle = 1.57079632679f;
  const float byDerivative = 2.0f - derivative / defaultMinimumDerivative;
  const float byAngle =
      (rightAngle - std::acos(std::clamp(nv, 0.0f, 1.0f))) / (rightAngle - defaultMinimumAngle);
  return std::clamp(std::max(byDerivative, byAngle), 0.0f, 1.0f);
}

/// Describes where a line may end, with everything that decides whether it passes there.
struct End {
  glm::vec3 position;
  glm::vec3 normal;
  float nv;
  float derivative;  ///< Dκr·F² as seen from outside
};

/// Finds the lines of one cluster.
class ClusterLines {
 public:
  ClusterLines(const ClusterWalk& walk, const LineRequest& request)
      : m_walk(walk),
        m_twoSided(request.twoSided),
        m_leastDerivative(request.thresholds.of(LineKind::suggestive, leastDerivative)),
        m_mostNv(std::cos(request.thresholds.of(LineKind::suggestive, leastAngle))) {}

  void extract(std::vector<Segment>& out) {
    if (!m_signs.find(m_walk))
      return;
    const std::span<const Signs::Crossed> crossed = m_signs.crossed(m_walk);
    for (const Signs::Crossed& triangle : crossed)
      for (const std::uint8_t corner : m_walk.local(triangle.triangle))
        m_values.want(corner);
    m_values.compute(m_walk);
    for (const Signs::Crossed& triangle : crossed)
      add(triangle, out);
  }

 private:
  void add(const Signs::Crossed& crossed, std::vector<Segment>& out) {
    const ClusterWalk::Local& local = m_walk.local(crossed.triangle);
    const auto largest = [&](const auto& valueAt) {
      return std::max(std::max(valueAt(local[0]), valueAt(local[1])), valueAt(local[2]));
    };
    const bool front = largest([&](std::uint8_t v) { return m_values.facingAt(v); }) > 0.0f;
    const bool back =
        m_twoSided && largest([&](std::uint8_t v) { return -m_values.facingAt(v); }) > 0.0f;
    // A condition that holds at no corner holds nowhere between them.
    const float strongest = largest(
        [&](std::uint8_t v) { return m_twoSided ? std::abs(derivativeAt(v)) : derivativeAt(v); });
    if (!(front || back) || !(strongest > m_leastDerivative))
      return;
    const std::array<Crossing, 2> on = m_walk.ends(
        local, crossed.odd, [this](std::uint8_t v) { return m_values.curvatureAt(v); },
        [this](std::uint8_t v) { return m_values.nvAt(v); });
    const std::array<End, 2> ends{endAt(on[0]), endAt(on[1])};
    if (front)
      addClipped(ends, 1.0f, crossed.triangle, out);
    if (back)
      addClipped(ends, -1.0f, crossed.triangle, out);
  }

  /// Returns Dκr·F².
  float derivativeAt(std::uint8_t local) const {
    const float f = m_walk.surface().featureSize;
    return f * f * m_values.derivativeAt(local);
  }

  End endAt(const Crossing& at) const {
    return {at.position, at.normal, at.nv, at.mix(derivativeAt(at.a), derivativeAt(at.b))};
  }

  /// Cuts the line to where all conditions of METHOD §5 hold on one side of the surface: `side` is
  /// 1 seen from outside, −1 from within (n and the derivative change sign).
  void addClipped(const std::array<End, 2>& c, float side, std::uint32_t triangle,
                  std::vector<Segment>& out) const {
    const auto excess = [&](const End& x) { return side * x.derivative - m_leastDerivative; };
    std::array<float, 2> range{0.0f, 1.0f};
    keepWherePositive(side * c[0].nv, side * c[1].nv, range);
    keepWherePositive(m_mostNv - side * c[0].nv, m_mostNv - side * c[1].nv, range);
    keepWherePositive(excess(c[0]), excess(c[1]), range);
    const auto [low, high] = range;
    if (!(low < high))
      return;
    // Returns exactly y at t = 1, so that a line's segments share their ends to the last bit.
    const auto mix = [](const auto& x, const auto& y, float t) {
      return t >= 1.0f ? y : x + t * (y - x);
    };
    const auto opacity = [&](float t) {
      // From 0 at the threshold to 1 at twice it: the ends fade out instead of popping (METHOD §5).
      const float t_d = std::max(m_leastDerivative, 1e-6f);
      return std::clamp(mix(excess(c[0]), excess(c[1]), t) / t_d, 0.0f, 1.0f);
    };
    out.push_back({.a = mix(c[0].position, c[1].position, low),
                   .b = mix(c[0].position, c[1].position, high),
                   .normalA = side * glm::normalize(mix(c[0].normal, c[1].normal, low)),
                   .normalB = side * glm::normalize(mix(c[0].normal, c[1].normal, high)),
                   .opacityA = opacity(low),
                   .opacityB = opacity(high),
                   .entryA = entry(side * mix(c[0].derivative, c[1].derivative, low),
                                   side * mix(c[0].nv, c[1].nv, low)),
                   .entryB = entry(side * mix(c[0].derivative, c[1].derivative, high),
                                   side * mix(c[0].nv, c[1].nv, high)),
                   .triangle = m_walk.triangle(triangle)});
  }

  const ClusterWalk& m_walk;
  bool m_twoSided;
  float m_leastDerivative;
  float m_mostNv;
  BendingSigns m_signs;
  RadialValues m_values;
};

}  // namespace

void setSuggestiveThresholds(Gamma gamma, LineThresholds& thresholds) {
  const float t = std::clamp(gamma.value() - 1.0f, 0.0f, 1.0f);
  constexpr float rightAngle = 1.57079632679f;
  thresholds.set(LineKind::suggestive, leastDerivative,
                 (1.0f - t) * defaultMinimumDerivative + defaultMinimumDerivative);
  thresholds.set(LineKind::suggestive, leastAngle,
                 rightAngle - (rightAngle - defaultMinimumAngle) * t);
}

bool suggestiveContoursMayPass(const model::Cluster& cluster, model::Facing,
                               const model::EyePoint& eye) {
  return mayBendBothWays(cluster, eye);
}

void extractSuggestiveContours(const ClusterWalk& walk, const LineRequest& request,
                               std::vector<Segment>& segments) {
  ClusterLines(walk, request).extract(segments);
}

void rankSuggestiveContours(std::vector<Segment>& segments, const model::Surface&,
                            const model::Camera&, float) {
  replaceByRank(segments, [](const Segment&) { return true; });
}

}  // namespace sline::render
