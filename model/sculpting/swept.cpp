// SPDX-License-Identifier: Apache-2.0
#include "model/sculpting/swept.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "model/sculpting/implicit.h"

namespace sline::model {

namespace {
constexpr std::size_t runLength = 8;
/// Beyond this distance the distance to the box around everything, a lower bound, is good enough.
constexpr float farFromRuns = 14.0f;

glm::vec3 direction(const glm::vec3& from, const glm::vec3& to) {
  const glm::vec3 d = to - from;
  const float length = glm::length(d);
  return length > 1e-6f ? d / length : glm::vec3(0, 0, 1);
}
}  // namespace

Swept::Swept(std::span<const SweptPoint> through, const glm::vec3& front, float step) {
  std::vector<Curve::Knot> knots;
  for (const SweptPoint& p : through)
    knots.push_back({glm::vec4(p.position, p.radius), glm::vec4(p.depth, 0, 0, 0)});
  const Curve curve(knots, step);
  for (const Curve::Knot& knot : curve.knots()) {
    Sample sample{.position = glm::vec3(knot.main),
                  .radius = std::max(knot.main.w, 0.1f),
                  .depth = knot.more.x,
                  .front = front};
    if (!m_samples.empty()) {
      const Sample& before = m_samples.back();
      const float piece = glm::distance(sample.position, before.position);
      sample.along = before.along + piece;
      sample.widths = before.widths + piece / (0.5f * (sample.radius + before.radius));
    }
    m_samples.push_back(sample);
  }
  smooth();
  carryFrames(front);
  gatherRuns();
}

/// Smooths the samples. The curve's curvature jumps at the given points, and so would that of the
/// wall, where drawn lines would show it. Binomial filters spread the jump over about a centimetre.
void Swept::smooth() {
  constexpr int passes = 14;
  for (int pass = 0; pass < passes; ++pass) {
    const std::vector<Sample> before = m_samples;
    for (std::size_t i = 1; i + 1 < m_samples.size(); ++i) {
      const auto filtered = [&](auto Sample::*field) {
        return 0.25f * (before[i - 1].*field + 2.0f * before[i].*field + before[i + 1].*field);
      };
      m_samples[i].position = filtered(&Sample::position);
      m_samples[i].radius = filtered(&Sample::radius);
      m_samples[i].depth = filtered(&Sample::depth);
      m_samples[i].along = filtered(&Sample::along);
      m_samples[i].widths = filtered(&Sample::widths);
    }
  }
}

/// Carries the frames along: each is the one before it, turned as little as keeps it square to the
/// curve.
void Swept::carryFrames(const glm::vec3& front) {
  glm::vec3 carried = front;
  for (std::size_t i = 0; i < m_samples.size(); ++i) {
    const std::size_t a = i > 0 ? i - 1 : i;
    const std::size_t b = std::min(i + 1, m_samples.size() - 1);
    const glm::vec3 tangent = direction(m_samples[a].position, m_samples[b].position);
    carried = glm::normalize(carried - glm::dot(carried, tangent) * tangent);
    m_samples[i].front = carried;
  }
}

void Swept::gatherRuns() {
  for (std::size_t first = 0; first + 1 < m_samples.size(); first += runLength) {
    Run run{first, std::min(first + runLength, m_samples.size() - 1), {}};
    for (std::size_t i = run.first; i <= run.last; ++i) {
      const Sample& s = m_samples[i];
      const float reach = s.radius * std::max(1.0f, s.depth);
      run.box.add(s.position - reach);
      run.box.add(s.position + reach);
    }
    m_bounds.add(run.box);
    m_runs.push_back(run);
  }
  for (std::size_t first = 0; first < m_runs.size(); first += runLength) {
    Run stretch{first, std::min(first + runLength, m_runs.size()), {}};
    for (std::size_t r = stretch.first; r < stretch.last; ++r)
      stretch.box.add(m_runs[r].box);
    m_stretches.push_back(stretch);
  }
}

Box Swept::bounds(float from, float to) const {
  Box box;
  for (const Run& run : m_runs)
    if (m_samples[run.last].along >= from && m_samples[run.first].along <= to)
      box.add(run.box);
  return box;
}

float Swept::alongNearest(const glm::vec3& p) const {
  const Nearest at = nearest(p, std::numeric_limits<float>::infinity());
  return glm::mix(m_samples[at.segment].along, m_samples[at.segment + 1].along, at.t);
}

SweptRing Swept::ring(float along) const {
  const auto after = std::lower_bound(m_samples.begin() + 1, m_samples.end() - 1, along,
                                      [](const Sample& s, float value) { return s.along < value; });
  const Sample& a = *(after - 1);
  const float t = std::clamp((along - a.along) / (after->along - a.along), 0.0f, 1.0f);
  Slopes slopes;
  const Sample at = onCurve(float(after - 1 - m_samples.begin()) + t, slopes);
  const glm::vec3 tangent = glm::normalize(slopes.tangent);
  const glm::vec3 front = glm::normalize(at.front - glm::dot(at.front, tangent) * tangent);
  return {at.position, front, glm::cross(tangent, front), at.radius};
}

float Swept::distanceToOthers(const glm::vec3& p, const SweptCoordinates& at, float reach) const {
  const float own = 3.5f * at.radius;
  float least = reach;
  for (const Run& run : m_runs) {
    if (std::abs(m_samples[run.first].along - at.along) < own ||
        std::abs(m_samples[run.last].along - at.along) < own || distanceToBox(run.box, p) > least)
      continue;
    Nearest best{.distance = least};
    searchRun(run, p, best);
    least = best.distance;
  }
  return least;
}

float Swept::beyond(float along, const glm::vec3& p, const SweptCoordinates& at) const {
  // Farther along, the tube may bend back through the plane of the cut.
  if (std::abs(at.along - along) > 2.0f * at.radius)
    return at.along - along;
  const auto after = std::lower_bound(m_samples.begin() + 1, m_samples.end() - 1, along,
                                      [](const Sample& s, float value) { return s.along < value; });
  const Sample& a = *(after - 1);
  const glm::vec3 tangent = direction(a.position, after->position);
  return glm::dot(p - a.position, tangent) - (along - a.along);
}

void Swept::searchRun(const Run& run, const glm::vec3& p, Nearest& best) const {
  for (std::size_t i = run.first; i < run.last; ++i) {
    const Sample& a = m_samples[i];
    const Sample& b = m_samples[i + 1];
    const glm::vec3 axis = b.position - a.position;
    const float t = std::clamp(glm::dot(p - a.position, axis) / glm::dot(axis, axis), 0.0f, 1.0f);
    const float d = glm::length(p - a.position - t * axis) - (a.radius + t * (b.radius - a.radius));
    if (d < best.distance)
      best = {i, t, d};
  }
}

Swept::Nearest Swept::nearest(const glm::vec3& p, float reach) const {
  Nearest best{.distance = std::numeric_limits<float>::infinity()};
  for (const Run& stretch : m_stretches) {
    if (distanceToBox(stretch.box, p) > std::min(std::max(best.distance, 0.0f), reach))
      continue;
    for (std::size_t r = stretch.first; r < stretch.last; ++r)
      if (distanceToBox(m_runs[r].box, p) <= std::min(std::max(best.distance, 0.0f), reach))
        searchRun(m_runs[r], p, best);
  }
  return best;
}

float Swept::distanceToRuns(const glm::vec3& p) const {
  float least = std::numeric_limits<float>::infinity();
  for (const Run& run : m_runs)
    least = std::min(least, distanceToBox(run.box, p));
  return least;
}

/// Returns the place on the cubic B-spline over the samples. The nearest place on the polyline
/// would leave a crease around the wall where two segments meet; the spline leaves none, and its
/// curvature is continuous.
Swept::Sample Swept::onCurve(float s, Slopes& slopes) const {
  const std::size_t last = m_samples.size() - 1;
  const std::size_t k = std::min(std::size_t(s), last - 1);
  const float t = s - float(k);
  const float r = 1.0f - t;
  const Sample& a = m_samples[k];
  const Sample& b = m_samples[k + 1];
  // Beyond the ends everything continues straight.
  const auto blend = [&](auto Sample::*field, const std::array<float, 4>& w) {
    const auto before = k > 0 ? m_samples[k - 1].*field : 2.0f * (a.*field) - b.*field;
    const auto after = k + 1 < last ? m_samples[k + 2].*field : 2.0f * (b.*field) - a.*field;
    return w[0] * before + w[1] * (a.*field) + w[2] * (b.*field) + w[3] * after;
  };
  const std::array<float, 4> first{-0.5f * r * r, 0.5f * (3 * t * t - 4 * t),
                                   0.5f * (4 * r - 3 * r * r), 0.5f * t * t};
  slopes = {blend(&Sample::position, first), blend(&Sample::position, {r, 3 * t - 2, 1 - 3 * t, t}),
            blend(&Sample::radius, first)};
  const std::array<float, 4> w{r * r * r / 6, (3 * t * t * t - 6 * t * t + 4) / 6,
                               (3 * r * r * r - 6 * r * r + 4) / 6, t * t * t / 6};
  return {blend(&Sample::position, w), blend(&Sample::radius, w), blend(&Sample::depth, w),
          blend(&Sample::along, w),    blend(&Sample::widths, w), blend(&Sample::front, w)};
}

SweptCoordinates Swept::place(const glm::vec3& p) const {
  const float toBox = distanceToBox(m_bounds, p);
  if (toBox > farFromRuns)
    return {.distance = toBox};
  const Nearest at = nearest(p, farFromRuns);
  if (std::isinf(at.distance))
    return {.distance = std::max(farFromRuns, distanceToRuns(p))};
  // Newton's method finds the place whose sphere is nearest, starting from the polyline's: the wall
  // is the envelope of spheres along the curve, so their caps join it smoothly where it widens.
  const float end = float(m_samples.size() - 1);
  float s = float(at.segment) + at.t;
  Slopes slopes;
  Sample foot = onCurve(s, slopes);
  for (int step = 0; step < 3; ++step) {
    const glm::vec3 d = foot.position - p;
    const float squared = glm::dot(slopes.tangent, slopes.tangent);
    const float off = glm::dot(d, slopes.tangent) - slopes.widening * glm::length(d);
    const float slope = std::max(
        squared + glm::dot(d, slopes.bend) - slopes.widening * slopes.widening, 0.3f * squared);
    const float better = std::clamp(s - std::clamp(off / slope, -1.0f, 1.0f), 0.0f, end);
    if (std::abs(better - s) < 1e-4f)
      break;
    s = better;
    foot = onCurve(s, slopes);
  }
  const glm::vec3 tangent = glm::normalize(slopes.tangent);
  const glm::vec3 front = glm::normalize(foot.front - glm::dot(foot.front, tangent) * tangent);
  const glm::vec3 side = glm::cross(tangent, front);
  const glm::vec3 offset = p - foot.position;
  const glm::vec3 local(glm::dot(offset, side), glm::dot(offset, front), glm::dot(offset, tangent));
  SweptCoordinates place;
  place.along = foot.along;
  place.widths = foot.widths;
  place.angle = std::atan2(local.x, local.y);
  place.radius = foot.radius;
  place.distance = std::abs(foot.depth - 1.0f) < 1e-3f
                       ? glm::length(offset) - foot.radius
                       : ellipsoid(local, {foot.radius, foot.radius * foot.depth, foot.radius});
  return place;
}

}  // namespace sline::model
