// SPDX-License-Identifier: Apache-2.0
// Holds the camera of one picture with everything that follows from it, in pixels of the whole
// picture with y upwards.
#pragma once

#include <algorithm>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "model/camera/camera.h"
#include "model/geometry/clusters.h"
#include "render/raster/pixel_rect.h"

namespace sline::render {

class PictureView {
 public:
  /// Takes in `bounds` what the depth range must hold.
  PictureView(const model::Camera& camera, const model::Box& bounds, int width, int height);

  const model::Camera& camera() const { return m_camera; }
  const model::Box& bounds() const { return m_bounds; }
  const model::EyePoint& eye() const { return m_eye; }
  /// Returns the position and 1, or for a parallel projection the direction and 0.
  glm::vec4 eyeVector() const { return {m_eye.value, m_eye.atInfinity ? 0.0f : 1.0f}; }
  /// Returns the matrix from the patient's to the camera's frame.
  const glm::mat4& viewMatrix() const { return m_view; }
  const glm::mat4& viewProjection() const { return m_viewProjection; }
  /// Returns the projection matrix' [2][2], [3][2], [2][3] and [3][3].
  const glm::vec4& depthTerms() const { return m_depthTerms; }
  glm::vec2 size() const { return m_size; }
  PixelRect whole() const { return {0, 0, int(m_size.x), int(m_size.y)}; }
  /// Returns λ in pixels, the unit of pens (METHOD §1).
  float outputUnit() const { return m_size.y / 720.0f; }
  /// Returns the size of a pixel at the point's depth; 0 behind a perspective camera.
  float millimetresPerPixel(const glm::vec3& p) const {
    // w is the distance from the eye's plane, or 1 in a parallel projection.
    return std::max(m_viewProjection[0][3] * p.x + m_viewProjection[1][3] * p.y +
                        m_viewProjection[2][3] * p.z + m_viewProjection[3][3],
                    0.0f) /
           m_focal.y;
  }

  struct Point {
    glm::vec2 pixel;
    float depth;  ///< window depth, 0 … 1 between near and far
    float w;      ///< ≤ 0 behind the eye
  };
  Point project(const glm::vec3& p) const;
  /// Returns the direction in the picture in which a point of the surface moves along its normal;
  /// zero where it moves straight towards the eye.
  glm::vec2 projectedDirection(const glm::vec3& p, const glm::vec3& normal) const;
  /// Converts a direction from the camera's frame (right, up, back) to the patient's.
  glm::vec3 toPatient(const glm::vec3& direction) const {
    return glm::transpose(glm::mat3(m_view)) * direction;
  }
  /// Returns the direction from a place of the picture to the eye, in the patient's frame and of
  /// any length; it is linear in the place.
  glm::vec3 towardsEye(const glm::vec2& pixel) const {
    return m_eye.atInfinity ? m_eye.value : toPatient({(0.5f * m_size - pixel) / m_focal, 1.0f});
  }
  /// Returns the pixels that the sphere can touch; the whole picture where it reaches behind the
  /// eye.
  PixelRect bounds(const model::Sphere& sphere) const;

 private:
  model::Camera m_camera;
  model::Box m_bounds;
  model::EyePoint m_eye;
  glm::mat4 m_view;
  glm::mat4 m_viewProjection;
  glm::vec4 m_depthTerms;
  glm::vec2 m_size;
  glm::vec2 m_focal;  ///< pixels per unit slope, or per millimetre in a parallel projection
};

}  // namespace sline::render
