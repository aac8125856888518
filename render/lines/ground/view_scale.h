// SPDX-License-Identifier: Apache-2.0
// Describes the picture in output units: λ = picture height / 720 (METHOD §1), the middle of the
// picture at the origin, y upwards. A layout in λ gives the same drawing at any size.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>

#include "model/camera/camera.h"

namespace sline::render {

class ViewScale {
 public:
  explicit ViewScale(const model::Camera& camera)
      : m_frame(model::cameraFrame(camera)),
        m_origin(camera.projection == model::Projection::perspective ? camera.eye : camera.target),
        m_perspective(camera.projection == model::Projection::perspective),
        m_unit((m_perspective ? 2.0f * model::edgeSlope(camera) : camera.heightMm) / 720.0f) {}

  struct Point {
    glm::vec2 at;      ///< λ
    float perMm;       ///< λ that a millimetre across the view takes here; 0 behind the eye
    float distanceMm;  ///< from the eye's plane
  };
  Point project(const glm::vec3& p) const {
    const glm::vec3 d = p - m_origin;
    const float distance = -glm::dot(d, m_frame.back);
    const float perMm = perMmAt(distance);
    return {perMm * glm::vec2(glm::dot(d, m_frame.right), glm::dot(d, m_frame.up)), perMm,
            distance};
  }

  /// Returns how many λ a millimetre takes at that distance from the eye's plane; 0 behind it.
  float perMmAt(float distanceMm) const {
    const float mm = m_perspective ? distanceMm * m_unit : m_unit;
    return mm > 0.0f ? 1.0f / mm : 0.0f;
  }

  /// What `project` does, for loops over many places: x = perMm·⟨p − origin, right⟩.
  struct Frame {
    glm::vec3 origin;
    glm::vec3 right;
    glm::vec3 up;
    glm::vec3 back;
    float unit;  ///< mm per λ, in perspective at a distance of 1 mm
  };
  Frame frame() const { return {m_origin, m_frame.right, m_frame.up, m_frame.back, m_unit}; }

  /// Returns the part of a direction that lies in the picture's plane.
  glm::vec2 across(const glm::vec3& direction) const {
    return {glm::dot(direction, m_frame.right), glm::dot(direction, m_frame.up)};
  }
  /// Returns the unit vector towards the eye, perpendicular to the picture's plane.
  const glm::vec3& towardsEye() const { return m_frame.back; }

 private:
  model::CameraFrame m_frame;
  glm::vec3 m_origin;
  bool m_perspective;
  float m_unit;  ///< mm per λ, in perspective at a distance of 1 mm
};

}  // namespace sline::render
