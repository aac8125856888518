// SPDX-License-Identifier: Apache-2.0
// Curve, and the two shapes along it: Tube and Band.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "model/demo/implicit.h"

namespace sline::model {

namespace {
using Knot = Curve::Knot;
constexpr std::size_t chunkSegments = 6;

Knot operator+(const Knot& a, const Knot& b) {
  return {a.main + b.main, a.more + b.more};
}
Knot operator-(const Knot& a, const Knot& b) {
  return {a.main - b.main, a.more - b.more};
}
Knot operator*(float s, const Knot& a) {
  return {s * a.main, s * a.more};
}

struct Timed {
  Knot value;
  float t;
};

/// Barry and Goldman's pyramid for a centripetal Catmull-Rom piece between the two middle knots.
Knot onPiece(const std::array<Timed, 4>& k, float t) {
  const auto mix = [t](const Knot& a, float ta, const Knot& b, float tb) {
    return a + (t - ta) / (tb - ta) * (b - a);
  };
  const Knot a1 = mix(k[0].value, k[0].t, k[1].value, k[1].t);
  const Knot a2 = mix(k[1].value, k[1].t, k[2].value, k[2].t);
  const Knot a3 = mix(k[2].value, k[2].t, k[3].value, k[3].t);
  const Knot b1 = mix(a1, k[0].t, a2, k[2].t);
  const Knot b2 = mix(a2, k[1].t, a3, k[3].t);
  return mix(b1, k[1].t, b2, k[2].t);
}

/// The given knots with one more at either end that continues the curve straight on.
std::vector<Timed> timed(std::span<const Knot> through) {
  std::vector<Timed> knots;
  const auto add = [&knots](const Knot& value) {
    const float t =
        knots.empty() ? 0.0f
                      : knots.back().t + std::sqrt(glm::distance(glm::vec3(knots.back().value.main),
                                                                 glm::vec3(value.main)));
    knots.push_back({value, t});
  };
  const std::size_t last = through.size() - 1;
  add(2.0f * through[0] - through[1]);
  for (const Knot& knot : through)
    add(knot);
  add(2.0f * through[last] - through[last - 1]);
  return knots;
}

std::vector<Knot> sampled(std::span<const Knot> through, float step) {
  const std::vector<Timed> knots = timed(through);
  std::vector<Knot> samples;
  for (std::size_t i = 0; i + 1 < through.size(); ++i) {
    const std::array<Timed, 4> piece{knots[i], knots[i + 1], knots[i + 2], knots[i + 3]};
    const float length = glm::distance(glm::vec3(through[i].main), glm::vec3(through[i + 1].main));
    const int steps = std::max(2, int(std::ceil(length / step)));
    for (int s = 0; s < steps + (i + 2 == through.size()); ++s)
      samples.push_back(
          onPiece(piece, piece[1].t + (piece[2].t - piece[1].t) * float(s) / float(steps)));
  }
  return samples;
}

/// Hermite's cubic and its first two derivatives.
struct Cubic {
  float h00, h10, h01, h11;

  static Cubic value(float t) {
    const float t2 = t * t;
    const float t3 = t2 * t;
    return {2 * t3 - 3 * t2 + 1, t3 - 2 * t2 + t, -2 * t3 + 3 * t2, t3 - t2};
  }
  static Cubic first(float t) {
    const float t2 = t * t;
    return {6 * t2 - 6 * t, 3 * t2 - 4 * t + 1, -6 * t2 + 6 * t, 3 * t2 - 2 * t};
  }
  static Cubic second(float t) { return {12 * t - 6, 6 * t - 4, -12 * t + 6, 6 * t - 2}; }
  glm::vec4 of(const glm::vec4& a, const glm::vec4& da, const glm::vec4& b,
               const glm::vec4& db) const {
    return h00 * a + h10 * da + h01 * b + h11 * db;
  }
};
}  // namespace

Curve::Curve(std::span<const Knot> through, float step) : m_knots(sampled(through, step)) {
  const std::size_t count = m_knots.size();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t before = i > 0 ? i - 1 : 0;
    const std::size_t after = std::min(i + 1, count - 1);
    m_slopes.push_back(1.0f / float(after - before) * (m_knots[after] - m_knots[before]));
  }
  for (std::size_t first = 0; first + 1 < count; first += chunkSegments) {
    const std::size_t end = std::min(first + chunkSegments, count - 1);
    Box box;
    for (std::size_t i = first; i <= end; ++i)
      box.add(glm::vec3(m_knots[i].main));
    float reach = 0.0f;
    for (std::size_t i = first; i <= end; ++i)
      reach = std::max(reach, glm::distance(box.centre(), glm::vec3(m_knots[i].main)) +
                                  std::max(m_knots[i].main.w, 0.0f));
    m_chunks.push_back({box.centre(), reach, first, end});
  }
}

void Curve::search(const Chunk& chunk, const glm::vec3& p, float weight, Nearest& best) const {
  for (std::size_t i = chunk.first; i < chunk.end; ++i) {
    const glm::vec3 from(m_knots[i].main);
    const glm::vec3 axis = glm::vec3(m_knots[i + 1].main) - from;
    const float t = std::clamp(glm::dot(p - from, axis) / glm::dot(axis, axis), 0.0f, 1.0f);
    const float radius = glm::mix(m_knots[i].main.w, m_knots[i + 1].main.w, t);
    const float d = glm::distance(p, from + t * axis) - weight * radius;
    if (d < best.distance)
      best = {i, t, d};
  }
}

Curve::Place Curve::nearest(const glm::vec3& p, float weight) const {
  Nearest best;
  std::size_t likely = 0;
  float least = std::numeric_limits<float>::infinity();
  for (std::size_t c = 0; c < m_chunks.size(); ++c) {
    const float bound = glm::distance(p, m_chunks[c].centre) - m_chunks[c].reach;
    if (bound < least) {
      least = bound;
      likely = c;
    }
  }
  search(m_chunks[likely], p, weight, best);
  for (std::size_t c = 0; c < m_chunks.size(); ++c)
    if (c != likely && glm::distance(p, m_chunks[c].centre) - m_chunks[c].reach < best.distance)
      search(m_chunks[c], p, weight, best);

  // From the chord to the smooth curve, so that no bend shows facets: Newton on (p − c)·c′ = 0.
  const std::size_t i = best.segment;
  const Knot& a = m_knots[i];
  const Knot& b = m_knots[i + 1];
  const Knot& da = m_slopes[i];
  const Knot& db = m_slopes[i + 1];
  const float low = i == 0 ? 0.0f : -0.5f;
  const float high = i + 2 == m_knots.size() ? 1.0f : 1.5f;
  float t = best.t;
  for (int step = 0; step < 2; ++step) {
    const glm::vec3 away = p - glm::vec3(Cubic::value(t).of(a.main, da.main, b.main, db.main));
    const glm::vec3 along(Cubic::first(t).of(a.main, da.main, b.main, db.main));
    const glm::vec3 bend(Cubic::second(t).of(a.main, da.main, b.main, db.main));
    const float square = glm::dot(along, along);
    const float slope = std::max(square - glm::dot(away, bend), 0.3f * square);
    t = std::clamp(t + glm::dot(away, along) / slope, low, high);
  }
  const Cubic value = Cubic::value(t);
  return {value.of(a.main, da.main, b.main, db.main), value.of(a.more, da.more, b.more, db.more),
          glm::normalize(glm::vec3(Cubic::first(t).of(a.main, da.main, b.main, db.main)))};
}

namespace {
/// Far away a box's distance, a lower bound, is as good: no blend reaches that far.
constexpr float farAway = 12.0f;

Curve curveOf(std::span<const TubePoint> through, float step) {
  std::vector<Knot> knots;
  for (const TubePoint& p : through)
    knots.push_back({glm::vec4(p.position, p.radius)});
  return Curve(knots, step);
}

Curve curveOf(std::span<const BandPoint> through, float step) {
  std::vector<Knot> knots;
  for (const BandPoint& p : through)
    knots.push_back(
        {glm::vec4(p.position, p.halfWidth), glm::vec4(glm::normalize(p.across), p.halfThickness)});
  return Curve(knots, step);
}

Box boundsOf(const Curve& curve) {
  Box box;
  for (const Knot& knot : curve.knots()) {
    const float radius = std::max(knot.main.w, knot.more.w);
    box.add(glm::vec3(knot.main) - radius);
    box.add(glm::vec3(knot.main) + radius);
  }
  return box;
}
}  // namespace

Tube::Tube(std::span<const TubePoint> through, float step)
    : m_curve(curveOf(through, step)), m_bounds(boundsOf(m_curve)) {}

float Tube::distance(const glm::vec3& p) const {
  const float toBox = distanceToBox(m_bounds, p);
  if (toBox > farAway)
    return toBox;
  const Curve::Place place = m_curve.nearest(p, 1.0f);
  return glm::distance(p, glm::vec3(place.main)) - std::max(place.main.w, 0.1f);
}

Band::Band(std::span<const BandPoint> through, float step)
    : m_curve(curveOf(through, step)), m_bounds(boundsOf(m_curve)) {}

float Band::distance(const glm::vec3& p) const {
  const float toBox = distanceToBox(m_bounds, p);
  if (toBox > farAway)
    return toBox;
  const Curve::Place place = m_curve.nearest(p, 0.0f);
  const glm::vec3 d = p - glm::vec3(place.main);
  const glm::vec3 normal = glm::normalize(glm::cross(place.tangent, glm::vec3(place.more)));
  const glm::vec3 across = glm::cross(normal, place.tangent);
  const float width = std::max(place.main.w, 0.1f);
  const float thickness = std::max(place.more.w, 0.1f);
  // Along the line only beyond an end, which is rounded like the thinner way across.
  return ellipsoid({glm::dot(d, across), glm::dot(d, normal), glm::dot(d, place.tangent)},
                   {width, thickness, std::min(width, thickness)});
}

}  // namespace sline::model
