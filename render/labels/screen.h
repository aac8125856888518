// SPDX-License-Identifier: Apache-2.0
// From the scene to the output's plane.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <optional>

#include "model/geometry/bvh.h"
#include "model/scene/camera.h"

namespace sline::render {

/// A camera's picture on paper: millimetres from the upper left corner, y downwards.
class Screen {
 public:
  /// Both sides of `size` must be positive and the camera without fault.
  Screen(const model::Camera& camera, const glm::vec2& size);

  const model::Camera& camera() const { return m_camera; }
  const glm::vec2& size() const { return m_size; }
  /// Nothing for a point that is not before the eye.
  std::optional<glm::vec2> place(const glm::vec3& p) const;
  /// From the eye (of a parallel projection: from behind it) through the place; the direction is a
  /// unit vector.
  model::Ray sight(const glm::vec2& place) const;
  bool inside(const glm::vec2& place) const;

 private:
  model::Camera m_camera;
  model::CameraFrame m_frame;
  glm::vec2 m_size;
  float m_scale = 1.0f;  ///< output millimetres of a unit slope, or of a millimetre
};

}  // namespace sline::render
