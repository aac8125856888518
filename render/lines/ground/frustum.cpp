// SPDX-License-Identifier: Apache-2.0
#include "render/lines/ground/frustum.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace sline::render {

Frustum::Frustum(const model::Camera& camera, float aspect) {
  const model::CameraFrame frame = model::cameraFrame(camera);
  if (camera.projection == model::Projection::orthographic) {
    const float up = 0.5f * camera.heightMm;
    const std::array<glm::vec3, 4> axes{frame.up, -frame.up, frame.right, -frame.right};
    for (std::size_t i = 0; i < 4; ++i)
      m_sides[i] = {axes[i], glm::dot(axes[i], camera.target) + (i < 2 ? up : aspect * up)};
    m_sides[4] = m_sides[0];
    return;
  }
  const float up = model::edgeSlope(camera);
  // Each side's normal is that axis, leaning back as far as the side leans outwards.
  const auto side = [&](const glm::vec3& axis, float slope) {
    const glm::vec3 outwards = glm::normalize(axis + slope * frame.back);
    return Side{outwards, glm::dot(outwards, camera.eye)};
  };
  m_sides = {side(frame.up, up), side(-frame.up, up), side(frame.right, aspect * up),
             side(-frame.right, aspect * up), Side{frame.back, glm::dot(frame.back, camera.eye)}};
}

bool Frustum::misses(const model::Sphere& sphere) const {
  return std::any_of(m_sides.begin(), m_sides.end(), [&](const Side& side) {
    return glm::dot(side.outwards, sphere.centre) - side.offset > sphere.radius;
  });
}

}  // namespace sline::render
