// SPDX-License-Identifier: Apache-2.0
// Maps the scene to the output's plane.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "model/camera/camera.h"
#include "model/geometry/bvh.h"
#include "render/labels/seen/shapes.h"

namespace sline::render {

/// Describes a camera's picture on paper: millimetres from the upper left corner, y downwards.
class Screen {
 public:
  /// Both sides of `size` must be positive and the camera valid.
  Screen(const model::Camera& camera, const glm::vec2& size);

  const model::Camera& camera() const { return m_camera; }
  const glm::vec2& size() const { return m_size; }
  /// Returns where a point lies; nothing for a point that is not in front of the eye.
  std::optional<glm::vec2> place(const glm::vec3& p) const;
  /// Returns the ray from the eye (in a parallel projection: from behind it) through the place; the
  /// direction is a unit vector.
  model::Ray sight(const glm::vec2& place) const;
  bool inside(const glm::vec2& place) const;
  /// Returns the same screen with something else over those parts of the picture, where one sees
  /// nothing of the scene.
  Screen coveredBy(std::vector<LabelBox> boxes) const {
    Screen screen = *this;
    screen.m_covered = std::move(boxes);
    return screen;
  }
  const std::vector<LabelBox>& covered() const { return m_covered; }
  /// Returns the same screen for a picture on a dark ground, or not: there light enters surfaces
  /// where on paper shadows do (METHOD §7).
  Screen onDark(bool dark) const {
    Screen screen = *this;
    screen.m_dark = dark;
    return screen;
  }
  bool dark() const { return m_dark; }
  /// Returns a number that grows with the distance from the eye's plane and is linear in the
  /// picture: in perspective −1 / distance, else the distance in millimetres. The point must be in
  /// front of the eye.
  float depthKey(const glm::vec3& p) const;
  /// Returns what weights in the picture are multiplied with to become weights in space.
  float inverseDepth(float key) const {
    return m_camera.projection == model::Projection::perspective ? -key : 1.0f;
  }

 private:
  model::Camera m_camera;
  model::CameraFrame m_frame;
  glm::vec2 m_size;
  float m_scale = 1.0f;  ///< output millimetres per unit slope, or per millimetre
  std::vector<LabelBox> m_covered;
  bool m_dark = false;
};

}  // namespace sline::render
