// SPDX-License-Identifier: Apache-2.0
#include "render/export/motion/turntable.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <map>
#include <numbers>

#include "model/scene/visible_structures.h"

namespace sline::render {

namespace {

using model::Camera;

/// The part of half the picture that things may reach to.
constexpr float reach = 0.97f;

/// Returns some of the points, about `most` at most, spread evenly.
std::vector<glm::vec3> fewOf(const std::vector<glm::vec3>& points, std::size_t most) {
  const std::size_t step = points.size() / most + 1;
  std::vector<glm::vec3> few;
  for (std::size_t i = 0; i < points.size(); i += step)
    few.push_back(points[i]);
  return few;
}

/// Returns where the points pass when they turn about the axis through `middle`: circles, as
/// points.
std::vector<glm::vec3> turned(const std::vector<glm::vec3>& points, const glm::vec3& middle,
                              const glm::vec3& axis) {
  constexpr int slices = 64;
  constexpr int around = 48;
  float low = 0.0f;
  float high = 0.0f;
  for (const glm::vec3& p : points) {
    low = std::min(low, glm::dot(p - middle, axis));
    high = std::max(high, glm::dot(p - middle, axis));
  }
  struct Circle {
    float height = 0.0f;
    float radius = 0.0f;
  };
  std::map<int, Circle> widest;
  for (const glm::vec3& p : points) {
    const float height = glm::dot(p - middle, axis);
    const float radius = glm::length(p - middle - height * axis);
    const int slice = int(float(slices) * (height - low) / std::max(high - low, 1e-6f));
    Circle& circle = widest[slice];
    if (radius >= circle.radius)
      circle = {height, radius};
  }
  const glm::vec3 other = std::abs(axis.x) < 0.7f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
  const glm::vec3 u = glm::normalize(glm::cross(axis, other));
  const glm::vec3 v = glm::cross(axis, u);
  std::vector<glm::vec3> circles;
  for (const auto& [slice, circle] : widest)
    for (int i = 0; i < around; ++i) {
      const float angle = 2.0f * std::numbers::pi_v<float> * float(i) / float(around);
      circles.push_back(middle + circle.height * axis +
                        circle.radius * (std::cos(angle) * u + std::sin(angle) * v));
    }
  return circles;
}

bool fits(const Camera& camera, const std::vector<glm::vec3>& points, const glm::vec2& limit) {
  const model::CameraFrame frame = model::cameraFrame(camera);
  const float slope = model::edgeSlope(camera);
  return std::ranges::all_of(points, [&](const glm::vec3& p) {
    const glm::vec3 from = p - camera.eye;
    const float half = camera.projection == model::Projection::perspective
                           ? -glm::dot(from, frame.back) * slope
                           : 0.5f * camera.heightMm;
    return half > 0.0f && std::abs(glm::dot(from, frame.right)) <= limit.x * half &&
           std::abs(glm::dot(from, frame.up)) <= limit.y * half;
  });
}

/// Returns the middle of the points' extent across the axis.
glm::vec3 middleOf(const std::vector<glm::vec3>& points, const glm::vec3& axis) {
  model::Box box;
  for (const glm::vec3& p : points)
    box.add(p);
  // Along the axis any place will do.
  return box.centre() - glm::dot(box.centre(), axis) * axis;
}

/// Returns the camera moved so that all points are in the part of the picture that is free.
Camera fittedWithin(const Camera& camera, const std::vector<glm::vec3>& points, float aspect,
                    const glm::vec2& share) {
  Camera fitted = model::fitted(camera, points, aspect * share.x / share.y);
  fitted.eye = fitted.target + (fitted.eye - fitted.target) / share.y;
  fitted.heightMm /= share.y;
  return fitted;
}

}  // namespace

Turntable::Turntable(const model::Scene& scene, const Camera& camera, float aspect,
                     const glm::vec2& share)
    : m_camera(camera), m_middle(camera.target) {
  const model::CameraFrame frame = model::cameraFrame(camera);
  constexpr float along = 0.97f;
  if (std::abs(frame.back.z) > along)
    m_axis = frame.up;
  const std::vector<glm::vec3> points = fewOf(model::visiblePoints(scene), 200'000);
  if (points.empty() || !fits(camera, points, {aspect, 1.0f}) ||
      fits(camera, turned(points, camera.target, m_axis), reach * share * glm::vec2(aspect, 1.0f)))
    return;
  m_middle = middleOf(points, m_axis);
  m_camera = fittedWithin(camera, turned(points, m_middle, m_axis), aspect, share);
}

Camera Turntable::at(double part) const {
  if (part <= 0.0 || part >= 1.0)
    return m_camera;
  const glm::dquat turn = glm::angleAxis(2.0 * std::numbers::pi * part, glm::dvec3(m_axis));
  const glm::dvec3 middle(m_middle);
  const auto turnedAbout = [&](const glm::vec3& p) {
    return glm::vec3(middle + turn * (glm::dvec3(p) - middle));
  };
  Camera camera = m_camera;
  camera.eye = turnedAbout(m_camera.eye);
  camera.target = turnedAbout(m_camera.target);
  camera.up = glm::vec3(turn * glm::dvec3(m_camera.up));
  return camera;
}

}  // namespace sline::render
