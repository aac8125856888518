// SPDX-License-Identifier: Apache-2.0
// Computes the axes of a camera, and intervals along them.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>

#include "model/camera/camera.h"

namespace sline::model {

struct CameraAxes {
  glm::dvec3 right;
  glm::dvec3 up;
  glm::dvec3 back;
};

/// Returns the axes in double precision, so that a scene a billion times smaller gives the same
/// picture.
inline CameraAxes axesOf(const Camera& camera) {
  const glm::dvec3 back = glm::normalize(glm::dvec3(camera.eye) - glm::dvec3(camera.target));
  const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(camera.up), back));
  return {right, glm::cross(back, right), back};
}

/// Returns the tangent of half the opening angle.
inline double halfTangent(const Camera& camera) {
  constexpr double radiansPerDegree = 3.14159265358979323846 / 180.0;
  return std::tan(0.5 * double(camera.fovyDegrees) * radiansPerDegree);
}

struct CameraInterval {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  double middle() const { return 0.5 * (low + high); }
  double length() const { return high - low; }
};

}  // namespace sline::model
