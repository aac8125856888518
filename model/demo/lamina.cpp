// SPDX-License-Identifier: Apache-2.0
#include "model/demo/lamina.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace sline::model {

namespace {
constexpr float sampleStep = 3.0f;  // mm
constexpr float farAway = 12.0f;

/// Weights of four neighbours in a uniform Catmull-Rom piece, and their derivatives.
struct Weights {
  std::array<float, 4> value;
  std::array<float, 4> slope;
};

Weights weightsAt(float t) {
  const float t2 = t * t;
  const float t3 = t2 * t;
  return {{0.5f * (-t + 2 * t2 - t3), 0.5f * (2 - 5 * t2 + 3 * t3), 0.5f * (t + 4 * t2 - 3 * t3),
           0.5f * (t3 - t2)},
          {0.5f * (-1 + 4 * t - 3 * t2), 0.5f * (-10 * t + 9 * t2), 0.5f * (1 + 8 * t - 9 * t2),
           0.5f * (3 * t2 - 2 * t)}};
}
}  // namespace

Lamina::Lamina(std::span<const LaminaPoint> points, std::size_t columns)
    : m_rows(int(points.size() / columns)), m_columns(int(columns)) {
  assert(points.size() == std::size_t(m_rows) * columns && m_rows > 1 && m_columns > 1);
  const auto given = [&](int row, int column) {
    const LaminaPoint& p = points[std::size_t(row) * columns + std::size_t(column)];
    return glm::vec4(p.position, p.halfThickness);
  };
  // Beyond the rims the sheet continues straight on.
  const auto beyond = [&](int row, int column) {
    const int r = std::clamp(row, 0, m_rows - 1);
    const int c = std::clamp(column, 0, m_columns - 1);
    const int r2 = std::clamp(2 * r - row, 0, m_rows - 1);
    const int c2 = std::clamp(2 * c - column, 0, m_columns - 1);
    return 2.0f * given(r, c) - given(r2, c2);
  };
  for (int row = -1; row <= m_rows; ++row)
    for (int column = -1; column <= m_columns; ++column)
      m_controls.push_back(beyond(row, column));
  addSamples();
}

glm::vec4 Lamina::control(int row, int column) const {
  const std::size_t width = std::size_t(m_columns) + 2;
  return m_controls[std::size_t(row + 1) * width + std::size_t(column + 1)];
}

Lamina::Place Lamina::at(float u, float v) const {
  const int column = std::clamp(int(std::floor(u)), 0, m_columns - 2);
  const int row = std::clamp(int(std::floor(v)), 0, m_rows - 2);
  const Weights wu = weightsAt(u - float(column));
  const Weights wv = weightsAt(v - float(row));
  Place place{};
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
  // One chunk per patch between four control points.
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
  if (toBox > farAway)
    return toBox;
  Sample s = nearestSample(p);
  // Gauss and Newton within the sheet; a coordinate at the rim stays there while p pulls outward.
  for (int step = 0; step < 3; ++step) {
    const Place place = at(s.u, s.v);
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
