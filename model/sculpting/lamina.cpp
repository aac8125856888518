// SPDX-License-Identifier: Apache-2.0
#include "model/sculpting/lamina.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace sline::model {

namespace {
constexpr float sampleStep = 3.0f;  // mm
constexpr float farFromLamina = 12.0f;

/// Holds the weights of four neighbours on a uniform cubic B-spline, and their derivatives.
struct SplineWeights {
  std::array<float, 4> value;
  std::array<float, 4> slope;
};

SplineWeights splineWeightsAt(float t) {
  const float s = 1.0f - t;
  return {{s * s * s / 6.0f, (3.0f * t * t * t - 6.0f * t * t + 4.0f) / 6.0f,
           (3.0f * s * s * s - 6.0f * s * s + 4.0f) / 6.0f, t * t * t / 6.0f},
          {-0.5f * s * s, 1.5f * t * t - 2.0f * t, 2.0f * s - 1.5f * s * s, 0.5f * t * t}};
}

/// Returns the control point before the first of a line, which continues with the same bend.
glm::vec4 beyondEnd(std::span<const glm::vec4> line) {
  return line.size() == 2 ? 2.0f * line[0] - line[1] : 3.0f * (line[0] - line[1]) + line[2];
}

/// Converts points in a line, `stride` apart, in place to the control points of the cubic B-spline
/// through them. They satisfy 6 p[i] = c[i−1] + 4 c[i] + c[i+1], solved by Gauss-Seidel iteration,
/// whose error falls to a quarter in each round.
void toControls(std::span<glm::vec4> line, std::size_t stride) {
  constexpr int rounds = 20;
  const std::size_t last = (line.size() - 1) / stride;
  if (last < 2)
    return;
  const std::vector<glm::vec4> points(line.begin(), line.end());
  for (int round = 0; round < rounds; ++round)
    for (std::size_t i = 0; i <= last; ++i) {
      const auto c = [&](std::size_t k) { return line[k * stride]; };
      const glm::vec4 wanted = 6.0f * points[i * stride];
      // At the ends the control point beyond is substituted.
      if (i == 0)
        line[0] = (wanted + 2.0f * c(1) - c(2)) / 7.0f;
      else if (i == last)
        line[i * stride] = (wanted + 2.0f * c(i - 1) - c(i - 2)) / 7.0f;
      else
        line[i * stride] = (wanted - c(i - 1) - c(i + 1)) / 4.0f;
    }
}
}  // namespace

Lamina::Lamina(std::span<const LaminaPoint> points, std::size_t columns)
    : m_rows(int(points.size() / columns)), m_columns(int(columns)) {
  assert(points.size() == std::size_t(m_rows) * columns && m_rows > 1 && m_columns > 1);
  const std::size_t width = columns + 2;
  m_controls.resize((std::size_t(m_rows) + 2) * width);
  const std::span<glm::vec4> all(m_controls);
  for (std::size_t i = 0; i < points.size(); ++i)
    all[(i / columns + 1) * width + i % columns + 1] =
        glm::vec4(points[i].position, points[i].halfThickness);
  for (std::size_t row = 1; row <= std::size_t(m_rows); ++row)
    toControls(all.subspan(row * width + 1, columns), 1);
  const std::size_t down = (std::size_t(m_rows) - 1) * width + 1;
  for (std::size_t column = 1; column <= columns; ++column)
    toControls(all.subspan(width + column, down), width);
  // One more control point is added all around: columns first, then whole rows.
  for (std::size_t row = 1; row <= std::size_t(m_rows); ++row) {
    std::vector<glm::vec4> line(&all[row * width + 1], &all[row * width + 1] + columns);
    all[row * width] = beyondEnd(line);
    std::reverse(line.begin(), line.end());
    all[row * width + columns + 1] = beyondEnd(line);
  }
  for (std::size_t column = 0; column < width; ++column) {
    std::vector<glm::vec4> line;
    for (std::size_t row = 1; row <= std::size_t(m_rows); ++row)
      line.push_back(all[row * width + column]);
    all[column] = beyondEnd(line);
    std::reverse(line.begin(), line.end());
    all[(std::size_t(m_rows) + 1) * width + column] = beyondEnd(line);
  }
  addSamples();
}

glm::vec4 Lamina::control(int row, int column) const {
  const std::size_t width = std::size_t(m_columns) + 2;
  return m_controls[std::size_t(row + 1) * width + std::size_t(column + 1)];
}

Lamina::PatchPoint Lamina::at(float u, float v) const {
  const int column = std::clamp(int(std::floor(u)), 0, m_columns - 2);
  const int row = std::clamp(int(std::floor(v)), 0, m_rows - 2);
  const SplineWeights wu = splineWeightsAt(u - float(column));
  const SplineWeights wv = splineWeightsAt(v - float(row));
  PatchPoint place{};
  for (int r = 0; r < 4; ++r) {
    glm::vec4 value(0.0f);
    glm::vec4 slope(0.0f);
    for (int c = 0; c < 4; ++c) {
      const glm::vec4 p = control(row - 1 + r, column - 1 + c);
      value += wu.value[std::size_t(c)] * p;
      slope += wu.slope[std::size_t(c)] * p;
    }
    place.value += wv.value[std::size_t(r)] * value;
    place.alongU += wv.value[std::size_t(r)] * slope;
    place.alongV += wv.slope[std::size_t(r)] * value;
  }
  return place;
}

void Lamina::addSamples() {
  // There is one chunk per patch between four control points.
  for (int row = 0; row + 1 < m_rows; ++row)
    for (int column = 0; column + 1 < m_columns; ++column) {
      const auto apart = [&](int r, int c) {
        return glm::distance(glm::vec3(control(row, column)),
                             glm::vec3(control(row + r, column + c)));
      };
      const int nu = std::max(2, int(std::ceil(apart(0, 1) / sampleStep)));
      const int nv = std::max(2, int(std::ceil(apart(1, 0) / sampleStep)));
      const std::size_t first = m_samples.size();
      Box box;
      for (int j = 0; j <= nv; ++j)
        for (int i = 0; i <= nu; ++i) {
          const float u = float(column) + float(i) / float(nu);
          const float v = float(row) + float(j) / float(nv);
          const glm::vec4 value = at(u, v).value;
          m_samples.push_back({glm::vec3(value), u, v});
          box.add(glm::vec3(value));
          m_bounds.add(glm::vec3(value) - value.w);
          m_bounds.add(glm::vec3(value) + value.w);
        }
      float reach = 0.0f;
      for (std::size_t s = first; s < m_samples.size(); ++s)
        reach = std::max(reach, glm::distance(box.centre(), m_samples[s].position));
      m_chunks.push_back({box.centre(), reach, first, m_samples.size()});
    }
}

Lamina::Sample Lamina::nearestSample(const glm::vec3& p) const {
  const auto bound = [&](const Chunk& chunk) {
    return glm::distance(p, chunk.centre) - chunk.reach;
  };
  const Sample* best = nullptr;
  float least = std::numeric_limits<float>::infinity();
  const auto search = [&](const Chunk& chunk) {
    for (std::size_t s = chunk.first; s < chunk.end; ++s) {
      const glm::vec3 d = p - m_samples[s].position;
      if (const float square = glm::dot(d, d); square < least * least) {
        least = std::sqrt(square);
        best = &m_samples[s];
      }
    }
  };
  const auto likely =
      std::min_element(m_chunks.begin(), m_chunks.end(),
                       [&](const Chunk& a, const Chunk& b) { return bound(a) < bound(b); });
  search(*likely);
  for (const Chunk& chunk : m_chunks)
    if (&chunk != &*likely && bound(chunk) < least)
      search(chunk);
  return *best;
}

float Lamina::distance(const glm::vec3& p) const {
  const float toBox = distanceToBox(m_bounds, p);
  if (toBox > farFromLamina)
    return toBox;
  Sample s = nearestSample(p);
  // This is Gauss-Newton within the sheet; a coordinate at the rim stays there while p pulls
  // outward.
  for (int step = 0; step < 3; ++step) {
    const PatchPoint place = at(s.u, s.v);
    const glm::vec3 away = p - glm::vec3(place.value);
    const glm::vec3 du(place.alongU);
    const glm::vec3 dv(place.alongV);
    const float uu = glm::dot(du, du);
    const float uv = glm::dot(du, dv);
    const float vv = glm::dot(dv, dv);
    const float au = glm::dot(away, du);
    const float av = glm::dot(away, dv);
    const float determinant = std::max(uu * vv - uv * uv, 1e-3f * uu * vv);
    float u = s.u + std::clamp((vv * au - uv * av) / determinant, -1.0f, 1.0f);
    float v = s.v + std::clamp((uu * av - uv * au) / determinant, -1.0f, 1.0f);
    const float endU = float(m_columns - 1);
    const float endV = float(m_rows - 1);
    if (u < 0.0f || u > endU) {
      u = std::clamp(u, 0.0f, endU);
      v = s.v + std::clamp((av - uv * (u - s.u)) / vv, -1.0f, 1.0f);
    }
    if (v < 0.0f || v > endV) {
      v = std::clamp(v, 0.0f, endV);
      u = std::clamp(s.u + std::clamp((au - uv * (v - s.v)) / uu, -1.0f, 1.0f), 0.0f, endU);
    }
    s = {glm::vec3(0.0f), u, v};
  }
  const glm::vec4 value = at(s.u, s.v).value;
  return glm::distance(p, glm::vec3(value)) - std::max(value.w, 0.1f);
}

}  // namespace sline::model
