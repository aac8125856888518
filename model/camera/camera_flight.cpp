// SPDX-License-Identifier: Apache-2.0
#include "model/camera/camera_flight.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

namespace sline::model {

namespace {

glm::dquat turnOf(const Camera& camera) {
  const CameraFrame frame = cameraFrame(camera);
  return glm::normalize(glm::quat_cast(
      glm::dmat3(glm::dvec3(frame.right), glm::dvec3(frame.up), glm::dvec3(frame.back))));
}

double between(double a, double b, double part) {
  return std::exp(std::lerp(std::log(a), std::log(b), part));
}

}  // namespace

Camera CameraFlight::at(double part) const {
  if (part >= 1.0)
    return m_to;
  if (part <= 0.0)
    return m_from;
  const double eased = part * part * (3.0 - 2.0 * part);
  const glm::dquat turn = glm::slerp(turnOf(m_from), turnOf(m_to), eased);
  const double distance = between(double(glm::length(m_from.eye - m_from.target)),
                                  double(glm::length(m_to.eye - m_to.target)), eased);
  Camera camera = m_to;
  camera.target = glm::mix(m_from.target, m_to.target, float(eased));
  camera.eye = glm::vec3(glm::dvec3(camera.target) + distance * (turn * glm::dvec3(0, 0, 1)));
  camera.up = glm::vec3(turn * glm::dvec3(0, 1, 0));
  camera.fovyDegrees = std::lerp(m_from.fovyDegrees, m_to.fovyDegrees, float(eased));
  camera.heightMm = float(between(double(m_from.heightMm), double(m_to.heightMm), eased));
  return camera;
}

}  // namespace sline::model
