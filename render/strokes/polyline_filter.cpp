// SPDX-License-Identifier: Apache-2.0
#include "render/strokes/polyline_filter.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace sline::render {

namespace {

constexpr float cornerCosine = 0.5f;  // of 60°
constexpr int boxes = 3;

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

}  // namespace

void blur(std::vector<glm::vec2>& points, float deviation, bool closed) {
  // Three boxes of 2r + 1 points have the variance (4r² + 4r) / 4.
  const int r = int(std::lround(0.5f * (std::sqrt(4.0f * deviation * deviation + 1.0f) - 1.0f)));
  if (r < 1 || points.size() < 3)
    return;
  const auto count = std::ptrdiff_t(points.size());
  const std::ptrdiff_t pad = std::ptrdiff_t(boxes) * r;
  const std::ptrdiff_t padded = count + 2 * pad;
  std::vector<glm::vec2> both(std::size_t(2 * padded));
  glm::vec2* line = both.data();
  glm::vec2* next = line + padded;
  for (std::ptrdiff_t i = 0; i < pad; ++i) {
    line[i] = extended(points, i - pad, closed);
    line[pad + count + i] = extended(points, count + i, closed);
  }
  std::copy_n(points.begin(), count, line + pad);
  const float share = 1.0f / float(2 * r + 1);
  std::ptrdiff_t from = r;
  std::ptrdiff_t to = padded - r;
  for (int box = 0; box < boxes; ++box, from += r, to -= r) {
    glm::dvec2 sum(0.0);
    for (std::ptrdiff_t k = from - r; k < from + r; ++k)
      sum += glm::dvec2(line[k]);
    for (std::ptrdiff_t i = from; i < to; ++i) {
      sum += glm::dvec2(line[i + r]);
      next[i] = share * glm::vec2(sum);
      sum -= glm::dvec2(line[i - r]);
    }
    std::swap(line, next);
  }
  std::copy_n(line + pad, count, points.begin());
}

std::vector<float> softMinimum(const std::vector<float>& values, int reach, bool closed) {
  const auto count = std::ptrdiff_t(values.size());
  const auto at = [&](const std::vector<float>& v, std::ptrdiff_t i) {
    return closed ? v[around(i, v.size())]
                  : v[std::size_t(std::clamp(i, std::ptrdiff_t(0), count - 1))];
  };
  std::vector<float> least(values.size());
  std::vector<float> soft(values.size());
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    float low = values[std::size_t(i)];
    for (std::ptrdiff_t k = -reach; k <= reach; ++k)
      low = std::min(low, at(values, i + k));
    least[std::size_t(i)] = low;
  }
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    float sum = 0.0f;
    for (std::ptrdiff_t k = -reach; k <= reach; ++k)
      sum += at(least, i + k);
    soft[std::size_t(i)] = sum / float(2 * reach + 1);
  }
  return soft;
}

std::vector<std::size_t> corners(const std::vector<glm::vec2>& points, int arm, bool closed) {
  const auto count = std::ptrdiff_t(points.size());
  std::vector<float> cosines(points.size(), 1.0f);
  const std::ptrdiff_t margin = closed ? 0 : arm;
  if (count < 2 * arm + 1)
    return {};
  for (std::ptrdiff_t i = margin; i < count - margin; ++i) {
    const glm::vec2 in = points[std::size_t(i)] - extended(points, i - arm, closed);
    const glm::vec2 out = extended(points, i + arm, closed) - points[std::size_t(i)];
    const float lengths = glm::length(in) * glm::length(out);
    if (lengths > 0.0f)
      cosines[std::size_t(i)] = glm::dot(in, out) / lengths;
  }
  std::vector<std::size_t> found;
  for (std::ptrdiff_t i = margin; i < count - margin; ++i) {
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
