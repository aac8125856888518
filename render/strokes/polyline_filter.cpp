// SPDX-License-Identifier: Apache-2.0
#include "render/strokes/polyline_filter.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "model/base/wide_loops.h"

namespace sline::render {

namespace {

constexpr float cornerCosine = 0.5f;  // of 60°
constexpr int boxes = 3;

// Wider boxes are summed from one point to the next, in double precision.
constexpr std::ptrdiff_t widestSum = 8;

/// Returns the index in 0 … count − 1 that lies there on a closed line.
std::size_t around(std::ptrdiff_t index, std::size_t count) {
  const auto n = std::ptrdiff_t(count);
  return std::size_t(((index % n) + n) % n);
}

/// Returns the point there, beyond the ends of an open line its image by reflection in the end.
glm::vec2 extended(const std::vector<glm::vec2>& points, std::ptrdiff_t i, bool closed) {
  const auto last = std::ptrdiff_t(points.size()) - 1;
  if (closed)
    return points[around(i, points.size())];
  if (i < 0)
    return 2.0f * points.front() - points[std::size_t(std::min(-i, last))];
  if (i > last)
    return 2.0f * points.back() - points[std::size_t(std::max(2 * last - i, std::ptrdiff_t(0)))];
  return points[std::size_t(i)];
}

/// Sets numbers from `from` to `to` to the mean of those so many pairs around them.
SLINE_WIDE_LOOPS
void meanOfPairs(const float* in, std::ptrdiff_t from, std::ptrdiff_t to, std::ptrdiff_t reach,
                 float* out) {
  const float share = 1.0f / float(2 * reach + 1);
  if (reach == 1) {
    for (std::ptrdiff_t i = from; i < to; ++i)
      out[i] = share * (in[i - 2] + in[i] + in[i + 2]);
    return;
  }
  if (reach == 2) {
    for (std::ptrdiff_t i = from; i < to; ++i)
      out[i] = share * ((in[i - 4] + in[i + 4]) + (in[i - 2] + in[i + 2]) + in[i]);
    return;
  }
  for (std::ptrdiff_t i = from; i < to; ++i)
    out[i] = in[i];
  for (std::ptrdiff_t k = 1; k <= reach; ++k)
    for (std::ptrdiff_t i = from; i < to; ++i)
      out[i] += in[i - 2 * k] + in[i + 2 * k];
  for (std::ptrdiff_t i = from; i < to; ++i)
    out[i] *= share;
}

void meanBySums(const glm::vec2* in, std::ptrdiff_t from, std::ptrdiff_t to, std::ptrdiff_t reach,
                glm::vec2* out) {
  const float share = 1.0f / float(2 * reach + 1);
  glm::dvec2 sum(0.0);
  for (std::ptrdiff_t k = from - reach; k < from + reach; ++k)
    sum += glm::dvec2(in[k]);
  for (std::ptrdiff_t i = from; i < to; ++i) {
    sum += glm::dvec2(in[i + reach]);
    out[i] = share * glm::vec2(sum);
    sum -= glm::dvec2(in[i - reach]);
  }
}

SLINE_WIDE_LOOPS
void leastAround(const float* in, std::size_t count, std::size_t reach, float* out) {
  for (std::size_t i = 0; i < count; ++i)
    out[i] = in[i];
  for (std::size_t k = 1; k <= 2 * reach; ++k)
    for (std::size_t i = 0; i < count; ++i)
      out[i] = in[i + k] < out[i] ? in[i + k] : out[i];
}

SLINE_WIDE_LOOPS
void meanAround(const float* in, std::size_t count, std::size_t reach, float* out) {
  for (std::size_t i = 0; i < count; ++i)
    out[i] = in[i];
  for (std::size_t k = 1; k <= 2 * reach; ++k)
    for (std::size_t i = 0; i < count; ++i)
      out[i] += in[i + k];
  const float share = 1.0f / float(2 * reach + 1);
  for (std::size_t i = 0; i < count; ++i)
    out[i] *= share;
}

/// Sets `out` to the values with so many more at both ends: of a closed line those that follow, of
/// an open one its ends again.
void pad(const std::vector<float>& values, std::size_t reach, bool closed,
         std::vector<float>& out) {
  out.resize(values.size() + 2 * reach);
  std::copy(values.begin(), values.end(), out.begin() + std::ptrdiff_t(reach));
  for (std::size_t i = 0; i < reach; ++i) {
    const auto before = std::ptrdiff_t(i) - std::ptrdiff_t(reach);
    const auto after = std::ptrdiff_t(values.size() + i);
    out[i] = closed ? values[around(before, values.size())] : values.front();
    out[values.size() + reach + i] = closed ? values[around(after, values.size())] : values.back();
  }
}

/// Sets `out` to the points with so many more at both ends (see `extended`).
void pad(const std::vector<glm::vec2>& points, std::ptrdiff_t reach, bool closed,
         std::vector<glm::vec2>& out) {
  const auto count = std::ptrdiff_t(points.size());
  out.resize(std::size_t(count + 2 * reach));
  for (std::ptrdiff_t i = 0; i < reach; ++i) {
    out[std::size_t(i)] = extended(points, i - reach, closed);
    out[std::size_t(reach + count + i)] = extended(points, count + i, closed);
  }
  std::copy(points.begin(), points.end(), out.begin() + reach);
}

/// Finds the cosines of the turns between the arms at `count` points, which follow `arm` others;
/// returns whether any is that of a corner.
SLINE_WIDE_LOOPS
bool findTurns(const glm::vec2* points, std::size_t count, std::size_t arm, float* cosines) {
  int sharp = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const glm::vec2 &before = points[i], &here = points[i + arm], &after = points[i + 2 * arm];
    const float inX = here.x - before.x, inY = here.y - before.y;
    const float outX = after.x - here.x, outY = after.y - here.y;
    const float squares = (inX * inX + inY * inY) * (outX * outX + outY * outY);
    const float cosine = (inX * outX + inY * outY) / std::sqrt(std::max(squares, 1e-30f));
    cosines[i] = squares > 0.0f ? cosine : 1.0f;
    sharp |= int(cosines[i] < cornerCosine);
  }
  return sharp != 0;
}

}  // namespace

void PolylineFilter::blur(std::vector<glm::vec2>& points, float deviation, bool closed) {
  // Three boxes of 2r + 1 points have the variance (4r² + 4r) / 4.
  const auto r =
      std::ptrdiff_t(std::lround(0.5f * (std::sqrt(4.0f * deviation * deviation + 1.0f) - 1.0f)));
  if (r < 1 || points.size() < 3)
    return;
  const auto count = std::ptrdiff_t(points.size());
  const std::ptrdiff_t reach = std::ptrdiff_t(boxes) * r;
  const std::ptrdiff_t padded = count + 2 * reach;
  pad(points, reach, closed, m_line);
  m_next.resize(std::size_t(padded));
  for (std::ptrdiff_t box = 1; box <= boxes; ++box) {
    if (r <= widestSum)
      meanOfPairs(&m_line[0].x, 2 * box * r, 2 * (padded - box * r), r, &m_next[0].x);
    else
      meanBySums(m_line.data(), box * r, padded - box * r, r, m_next.data());
    std::swap(m_line, m_next);
  }
  std::copy_n(m_line.begin() + reach, count, points.begin());
}

void PolylineFilter::softMinimum(std::vector<float>& values, int reach, bool closed) {
  const auto r = std::size_t(reach);
  m_least.resize(values.size());
  pad(values, r, closed, m_values);
  leastAround(m_values.data(), values.size(), r, m_least.data());
  pad(m_least, r, closed, m_values);
  meanAround(m_values.data(), values.size(), r, values.data());
}

std::vector<std::size_t> PolylineFilter::corners(const std::vector<glm::vec2>& points, int arm,
                                                 bool closed) {
  const auto count = std::ptrdiff_t(points.size());
  const std::ptrdiff_t margin = closed ? 0 : arm;
  if (count < 2 * arm + 1)
    return {};
  std::vector<float>& cosines = m_values;
  cosines.assign(points.size(), 1.0f);
  pad(points, arm - margin, closed, m_line);
  const bool any = findTurns(m_line.data(), std::size_t(count - 2 * margin), std::size_t(arm),
                             cosines.data() + margin);
  std::vector<std::size_t> found;
  for (std::ptrdiff_t i = margin; any && i < count - margin; ++i) {
    if (!(cosines[std::size_t(i)] < cornerCosine))
      continue;
    bool sharpest = true;
    for (std::ptrdiff_t k = -arm; k <= arm && sharpest; ++k) {
      const std::ptrdiff_t other = closed ? std::ptrdiff_t(around(i + k, points.size())) : i + k;
      if (other < 0 || other >= count || k == 0)
        continue;
      const float there = cosines[std::size_t(other)];
      const float here = cosines[std::size_t(i)];
      sharpest = here < there || (here == there && k > 0);
    }
    if (sharpest)
      found.push_back(std::size_t(i));
  }
  return found;
}

}  // namespace sline::render
