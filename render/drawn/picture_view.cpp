// SPDX-License-Identifier: Apache-2.0
#include "render/drawn/picture_view.h"

#include <algorithm>
#include <cmath>

#include "render/lines/ground/view_fields.h"

namespace sline::render {

PictureView::PictureView(const model::Camera& camera, const model::Box& bounds, int width,
                         int height)
    : m_camera(camera),
      m_bounds(bounds),
      m_eye(eyeOf(camera)),
      m_view(model::viewMatrix(camera)),
      m_size(float(width), float(height)) {
  const glm::mat4 projection =
      model::projectionMatrix(camera, bounds, float(width) / float(height));
  m_viewProjection = projection * m_view;
  m_depthTerms = {projection[2][2], projection[3][2], projection[2][3], projection[3][3]};
  m_focal = 0.5f * m_size * glm::vec2(projection[0][0], projection[1][1]);
}

PictureView::Point PictureView::project(const glm::vec3& p) const {
  const glm::vec4 clip = m_viewProjection * glm::vec4(p, 1.0f);
  const glm::vec3 ndc = glm::vec3(clip) / clip.w;
  return {
      .pixel = (0.5f * glm::vec2(ndc) + 0.5f) * m_size, .depth = 0.5f * ndc.z + 0.5f, .w = clip.w};
}

glm::vec2 PictureView::projectedDirection(const glm::vec3& p, const glm::vec3& normal) const {
  const glm::vec3 n = glm::mat3(m_view) * normal;
  glm::vec2 direction(n);
  if (!m_eye.atInfinity) {
    // The derivative of (x, y)/−z, times the positive z².
    const glm::vec3 q = glm::vec3(m_view * glm::vec4(p, 1.0f));
    direction = glm::vec2(n) * -q.z + glm::vec2(q) * n.z;
  }
  const float length = glm::length(direction);
  return length > 1e-20f ? direction / length : glm::vec2(0.0f);
}

PixelRect PictureView::bounds(const model::Sphere& sphere) const {
  const glm::vec3 c = glm::vec3(m_view * glm::vec4(sphere.centre, 1.0f));
  const float r = sphere.radius;
  glm::vec2 low = glm::vec2(c) - r;
  glm::vec2 high = glm::vec2(c) + r;
  if (!m_eye.atInfinity) {
    const float nearest = -c.z - r;
    if (nearest < 1e-3f * r || nearest <= 0.0f)
      return whole();
    const float farthest = -c.z + r;
    for (int i = 0; i < 2; ++i) {
      low[i] /= low[i] < 0.0f ? nearest : farthest;
      high[i] /= high[i] > 0.0f ? nearest : farthest;
    }
  }
  // Far outside, floats leave the range of int.
  const glm::vec2 limit(1e6f);
  low = glm::clamp(0.5f * m_size + low * m_focal, -limit, limit);
  high = glm::clamp(0.5f * m_size + high * m_focal, -limit, limit);
  const int x = int(std::floor(low.x));
  const int y = int(std::floor(low.y));
  return {x, y, int(std::ceil(high.x)) - x, int(std::ceil(high.y)) - y};
}

}  // namespace sline::render
