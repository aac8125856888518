// SPDX-License-Identifier: Apache-2.0
#include "render/labels/seen/screen.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace sline::render {

Screen::Screen(const model::Camera& camera, const glm::vec2& size)
    : m_camera(camera), m_frame(model::cameraFrame(camera)), m_size(size) {
  m_scale = camera.projection == model::Projection::perspective
                ? 0.5f * size.y / model::edgeSlope(camera)
                : size.y / camera.heightMm;
}

std::optional<glm::vec2> Screen::place(const glm::vec3& p) const {
  const glm::vec3 from = p - m_camera.eye;
  glm::vec2 across(glm::dot(from, m_frame.right), -glm::dot(from, m_frame.up));
  if (m_camera.projection == model::Projection::perspective) {
    const float depth = -glm::dot(from, m_frame.back);
    if (!(depth > 0.0f))
      return std::nullopt;
    across /= depth;
  }
  const glm::vec2 place = 0.5f * m_size + m_scale * across;
  if (!std::isfinite(place.x) || !std::isfinite(place.y))
    return std::nullopt;
  return place;
}

model::Ray Screen::sight(const glm::vec2& place) const {
  const glm::vec2 across = (place - 0.5f * m_size) / m_scale;
  const glm::vec3 aside = across.x * m_frame.right - across.y * m_frame.up;
  if (m_camera.projection == model::Projection::perspective)
    return {.origin = m_camera.eye, .direction = glm::normalize(aside - m_frame.back)};
  return {.origin = m_camera.eye + aside,
          .direction = -m_frame.back,
          .nearest = -std::numeric_limits<float>::infinity()};
}

float Screen::depthKey(const glm::vec3& p) const {
  const float depth = -glm::dot(p - m_camera.eye, m_frame.back);
  return m_camera.projection == model::Projection::perspective ? -1.0f / depth : depth;
}

bool Screen::inside(const glm::vec2& place) const {
  return place.x >= 0.0f && place.y >= 0.0f && place.x <= m_size.x && place.y <= m_size.y;
}

}  // namespace sline::render
