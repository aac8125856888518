// SPDX-License-Identifier: Apache-2.0
// Implements Curve and the two shapes along it: Tube and Band.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "model/sculpting/implicit.h"

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

/// Returns the given knots with the parameters at which the curve passes them: centripetal, steps
/// being the root of the distance.
std::vector<Timed> timed(std::span<const Knot> through) {
  std::vector<Timed> knots;
  for (const Knot& knot : through) {
    const float t =
        knots.empty() ? 0.0f
                      : knots.back().t + std::sqrt(glm::distance(glm::vec3(knots.back().value.main),
                                                                 glm::vec3(knot.main)));
    knots.push_back({knot, t});
  }
  return knots;
}

/// Returns the second derivatives at the knots of the cubic spline through them, constant within
/// the end pieces (Thomas' elimination): curvature is continuous, or else lines would show each
/// knot on the wall.
std::vector<Knot> bends(const std::vector<Timed>& k) {
  std::vector<Knot> bend(k.size());
  std::vector<float> above(k.size(), 0.0f);
  for (std::size_t i = 1; i + 1 < k.size(); ++i) {
    const float before = k[i].t - k[i - 1].t;
    const float after = k[i + 1].t - k[i].t;
    const Knot turn = 1.0f / after * (k[i + 1].value - k[i].value) -
                      1.0f / before * (k[i].value - k[i - 1].value);
    // The second derivative at the end equals that of its neighbour.
    const float ends = (i == 1 ? before : 0.0f) + (i + 2 == k.size() ? after : 0.0f);
    const float pivot = 2.0f * (before + after) + ends - before * above[i - 1];
    above[i] = after / pivot;
    bend[i] = 1.0f / pivot * (6.0f * turn - before * bend[i - 1]);
  }
  for (std::size_t i = k.size() - 1; i-- > 1;)
    bend[i] = bend[i] - above[i] * bend[i + 1];
  bend.front() = bend[1];
  bend.back() = bend[k.size() - 2];
  return bend;
}

std::vector<Knot> sampled(std::span<const Knot> through, float step) {
  const std::vector<Timed> knots = timed(through);
  const std::vector<Knot> bend = bends(knots);
  std::vector<Knot> samples;
  for (std::size_t i = 0; i + 1 < through.size(); ++i) {
    const float h = knots[i + 1].t - knots[i].t;
    const auto onPiece = [&](float u) {
      const auto cubic = [h](float v) { return h * h / 6.0f * (v * v * v - v); };
      return (1.0f - u) * knots[i].value + u * knots[i + 1].value +
             (cubic(1.0f - u) * bend[i] + cubic(u) * bend[i + 1]);
    };
    const float length = glm::distance(glm::vec3(through[i].main), glm::vec3(through[i + 1].main));
    const int steps = std::max(2, int(std::ceil(length / step)));
    for (int s = 0; s < steps + (i + 2 == through.size()); ++s)
      samples.push_back(onPiece(float(s) / float(steps)));
  }
  return samples;
}

/// Holds the weights of four successive samples on a uniform cubic B-spline between the middle two,
/// and their first and second derivatives. Its curvature is continuous.
struct Weights {
  std::array<float, 4> value;
  std::array<float, 4> first;
  std::array<float, 4> second;
};

Weights weightsAt(float t) {
  const float s = 1.0f - t;
  return {{s * s * s / 6.0f, (3.0f * t * t * t - 6.0f * t * t + 4.0f) / 6.0f,
           (3.0f * s * s * s - 6.0f * s * s + 4.0f) / 6.0f, t * t * t / 6.0f},
          {-0.5f * s * s, 1.5f * t * t - 2.0f * t, 2.0f * s - 1.5f * s * s, 0.5f * t * t},
          {s, 3.0f * t - 2.0f, 3.0f * s - 2.0f, t}};
}
}  // namespace

Curve::Curve(std::span<const Knot> through, float step) : m_knots(sampled(through, step)) {
  const std::size_t count = m_knots.size();
  // Beyond its ends the curve is straight.
  m_spline.push_back(2.0f * m_knots[0] - m_knots[1]);
  m_spline.insert(m_spline.end(), m_knots.begin(), m_knots.end());
  // A B-spline cuts corners by a sixth of the second difference.
  for (std::size_t i = 1; i + 1 < count; ++i)
    m_spline[i + 1] =
        m_knots[i] - 1.0f / 6.0f * (m_knots[i - 1] + m_knots[i + 1] - 2.0f * m_knots[i]);
  m_spline.push_back(2.0f * m_knots[count - 1] - m_knots[count - 2]);
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

  // The search goes from the chord to the smooth curve, so that no bend shows facets: Newton on (p
  // − c)·c′ = 0.
  const float end = float(m_knots.size() - 1);
  float s = float(best.segment) + best.t;
  for (int step = 0; step < 3; ++step) {
    const std::size_t i = pieceAt(s);
    const Weights w = weightsAt(s - float(i));
    const glm::vec3 away = p - glm::vec3(mixed(i, w.value).main);
    const glm::vec3 along(mixed(i, w.first).main);
    const glm::vec3 bend(mixed(i, w.second).main);
    const float square = glm::dot(along, along);
    const float slope = std::max(square - glm::dot(away, bend), 0.3f * square);
    s = std::clamp(s + std::clamp(glm::dot(away, along) / slope, -1.0f, 1.0f), 0.0f, end);
  }
  return at(s);
}

Curve::Place Curve::at(float s) const {
  const std::size_t i = pieceAt(s);
  const Weights w = weightsAt(s - float(i));
  const Knot here = mixed(i, w.value);
  return {here.main, here.more, glm::normalize(glm::vec3(mixed(i, w.first).main))};
}

std::size_t Curve::pieceAt(float s) const {
  return std::min(std::size_t(s), m_knots.size() - 2);
}

Curve::Knot Curve::mixed(std::size_t piece, const std::array<float, 4>& weights) const {
  const Knot* k = &m_spline[piece];
  return weights[0] * k[0] + weights[1] * k[1] + (weights[2] * k[2] + weights[3] * k[3]);
}

namespace {
/// Farther away than this the box's distance, a lower bound, serves as well: no blend reaches that
/// far.
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
  // The offset along the line counts only beyond an end, which is rounded like the thinner way
  // across.
  return ellipsoid({glm::dot(d, across), glm::dot(d, normal), glm::dot(d, place.tangent)},
                   {width, thickness, std::min(width, thickness)});
}

}  // namespace sline::model
