// SPDX-License-Identifier: Apache-2.0
#include "widgets/brush/brush_stroke.h"

#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

namespace sline::widgets {

namespace {

float distanceTo(const glm::vec2& from, const glm::vec2& to, const glm::vec2& p) {
  const glm::vec2 way = to - from;
  const float length = glm::dot(way, way);
  const float part =
      length > 0.0f ? glm::clamp(glm::dot(p - from, way) / length, 0.0f, 1.0f) : 0.0f;
  return glm::distance(p, from + part * way);
}

}  // namespace

float brushWeight(const Brush& brush, float pixels) {
  if (pixels >= brush.radius)
    return 0.0f;
  const float core = (1.0f - brush.softness) * brush.radius;
  if (pixels <= core)
    return brush.strength;
  return brush.strength * (1.0f - glm::smoothstep(core, brush.radius, pixels));
}

BrushStroke::BrushStroke(BrushSightPtr sight, const model::PaintPtr& before, const Brush& brush)
    : m_sight(std::move(sight)),
      m_brush(brush),
      m_covered(m_sight->from().ground->mesh->vertexCount(), 0.0f),
      m_before(before ? *before : model::Paint(m_covered.size(), 0)),
      m_paint(m_before) {}

bool BrushStroke::cover(std::uint32_t vertex, float weight) {
  if (weight <= m_covered[vertex])
    return false;
  m_covered[vertex] = weight;
  const float before = m_before[vertex];
  const float target = m_brush.erases ? 0.0f : 255.0f;
  const auto value = std::uint8_t(std::lround(glm::mix(before, target, weight)));
  const bool changes = m_paint[vertex] != value;
  m_paint[vertex] = value;
  return changes;
}

bool BrushStroke::move(const glm::vec2& from, const glm::vec2& to) {
  std::vector<std::uint32_t> touched;
  std::vector<float> weights;
  m_sight->visit(glm::min(from, to) - m_brush.radius, glm::max(from, to) + m_brush.radius,
                 [&](std::uint32_t v, const glm::vec2& pixel) {
                   const float weight = brushWeight(m_brush, distanceTo(from, to, pixel));
                   if (weight <= m_covered[v])
                     return;
                   touched.push_back(v);
                   weights.push_back(weight);
                 });
  m_sight->look(touched);
  bool changed = false;
  for (std::size_t i = 0; i < touched.size(); ++i)
    if (m_sight->sees(touched[i]))
      changed = cover(touched[i], weights[i]) || changed;
  // A brush smaller than the triangles paints all the same.
  if (touched.empty())
    if (const auto corner = m_sight->cornerAt(to))
      changed = cover(*corner, m_brush.strength) || changed;
  return changed;
}

}  // namespace sline::widgets
