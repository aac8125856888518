// SPDX-License-Identifier: Apache-2.0
#include "model/camera/camera_moves.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>

namespace sline::model {

namespace {

constexpr glm::dvec3 longAxis(0.0, 0.0, 1.0);
/// The degrees by which a drag over the picture's whole height turns.
constexpr float degreesPerHeight = 200.0f;
/// The slant of the horizon below which it is rounding, left over from earlier turns.
constexpr double levelSlant = 1e-3;
/// The factor by which a drag upwards over the picture's whole height enlarges the scene.
constexpr float zoomPerHeight = 8.0f;

glm::vec2 centred(const glm::vec2& pixel, const glm::vec2& size) {
  return {(2.0f * pixel.x - size.x) / size.y, (size.y - 2.0f * pixel.y) / size.y};
}

}  // namespace

Camera orbited(const Camera& camera, const glm::vec3& pivot, float turnDegrees, float tiltDegrees) {
  const CameraFrame frame = cameraFrame(camera);
  glm::dvec3 right(frame.right);
  if (std::abs(right.z) < levelSlant && glm::length(glm::dvec2(right)) > 0.5)
    right = glm::normalize(glm::dvec3(right.x, right.y, 0.0));
  glm::dvec3 back(frame.back);
  back = glm::normalize(back - glm::dot(back, right) * right);
  const glm::dvec3 up = glm::cross(back, right);

  const double elevation = std::atan2(back.z, up.z);
  const double pole = std::max(glm::radians(90.0), std::abs(elevation));
  const double tilt =
      std::clamp(elevation + glm::radians(double(tiltDegrees)), -pole, pole) - elevation;
  // The camera goes the opposite way to the scene's apparent movement.
  const glm::dquat tilting = glm::angleAxis(-tilt, right);
  const glm::dquat turning = glm::angleAxis(-glm::radians(double(turnDegrees)), longAxis);
  const glm::dquat both = turning * tilting;

  const glm::dvec3 centre(pivot);
  Camera turned = camera;
  turned.eye = glm::vec3(centre + both * (glm::dvec3(camera.eye) - centre));
  turned.target = glm::vec3(centre + both * (glm::dvec3(camera.target) - centre));
  turned.up = glm::vec3(both * up);
  return turned;
}

Camera panned(const Camera& camera, const glm::vec3& at, const glm::vec2& pixels, float height) {
  const CameraFrame frame = cameraFrame(camera);
  float scale = millimetresPerPixel(camera, at, height);
  if (scale <= 0.0f)
    scale = millimetresPerPixel(camera, camera.target, height);
  const glm::vec3 step = scale * (-pixels.x * frame.right + pixels.y * frame.up);
  Camera moved = camera;
  moved.eye += step;
  moved.target += step;
  return moved;
}

Camera zoomed(const Camera& camera, const glm::vec3& at, float factor) {
  Camera nearer = camera;
  const float scale = 1.0f / factor;
  nearer.eye = at + scale * (camera.eye - at);
  nearer.target = at + scale * (camera.target - at);
  nearer.heightMm *= scale;
  return cameraFault(nearer) ? camera : nearer;
}

Camera withHeight(Camera camera, float times) {
  camera.heightMm *= times;
  camera.fovyDegrees = glm::degrees(2.0f * std::atan(times * edgeSlope(camera)));
  return camera;
}

ZoomEnds zoomEnds(const Box& visible) {
  constexpr float leastShare = 1e-4f;
  constexpr float greatestShare = 100.0f;
  // Pixels then still are some roundings of a coordinate apart.
  constexpr float roundings = 2e-5f;
  const float size = visible.empty() ? 1000.0f : glm::length(visible.size());
  if (!(size > 0.0f))
    return {};
  const float away = visible.empty() ? 0.0f : glm::length(visible.centre());
  return {.least = std::max(leastShare * size, roundings * away), .greatest = greatestShare * size};
}

Camera zoomedWithin(const Camera& camera, const glm::vec3& at, float factor, const ZoomEnds& ends) {
  float shown = millimetresPerPixel(camera, at, 1.0f);
  if (!(shown > 0.0f))
    shown = millimetresPerPixel(camera, camera.target, 1.0f);
  if (!(shown > 0.0f) || !(factor > 0.0f))
    return camera;
  const float wanted =
      std::clamp(shown / factor, std::min(shown, ends.least), std::max(shown, ends.greatest));
  return wanted == shown ? camera : zoomed(camera, at, shown / wanted);
}

Camera rolled(const Camera& camera, float degrees) {
  const CameraFrame frame = cameraFrame(camera);
  // An upright thing leans to the right where the camera's up leans to the left.
  const double angle = glm::radians(double(degrees));
  Camera turned = camera;
  turned.up =
      glm::vec3(std::cos(angle) * glm::dvec3(frame.up) - std::sin(angle) * glm::dvec3(frame.right));
  return turned;
}

Camera turnedTo(const Camera& camera, const glm::vec3& pivot, const glm::vec3& from,
                const glm::vec3& up) {
  const CameraFrame frame = cameraFrame(camera);
  const glm::dvec3 back = glm::normalize(glm::dvec3(from));
  const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(up), back));
  const glm::dvec3 upright = glm::cross(back, right);
  const auto moved = [&](const glm::vec3& p) {
    const glm::dvec3 way = glm::dvec3(p) - glm::dvec3(pivot);
    return glm::vec3(glm::dvec3(pivot) + glm::dot(way, glm::dvec3(frame.right)) * right +
                     glm::dot(way, glm::dvec3(frame.up)) * upright +
                     glm::dot(way, glm::dvec3(frame.back)) * back);
  };
  Camera turned = camera;
  turned.eye = moved(camera.eye);
  turned.target = moved(camera.target);
  turned.up = glm::vec3(upright);
  return turned;
}

Ray sightThrough(const Camera& camera, const glm::vec2& pixel, const glm::vec2& size) {
  const CameraFrame frame = cameraFrame(camera);
  const glm::vec2 c = centred(pixel, size);
  if (camera.projection == Projection::orthographic) {
    const float half = 0.5f * camera.heightMm;
    return {.origin = camera.eye + half * (c.x * frame.right + c.y * frame.up),
            .direction = -frame.back};
  }
  const float slope = edgeSlope(camera);
  return {.origin = camera.eye,
          .direction = glm::normalize(slope * (c.x * frame.right + c.y * frame.up) - frame.back)};
}

glm::vec3 pointAtDepthOf(const Camera& camera, const glm::vec3& at, const glm::vec2& pixel,
                         const glm::vec2& size) {
  const Ray ray = sightThrough(camera, pixel, size);
  const glm::vec3 forward = -cameraFrame(camera).back;
  float depth = glm::dot(at - camera.eye, forward);
  if (camera.projection == Projection::perspective && depth <= 0.0f)
    depth = glm::dot(camera.target - camera.eye, forward);
  return ray.origin + depth / glm::dot(ray.direction, forward) * ray.direction;
}

std::optional<glm::vec2> pixelOf(const Camera& camera, const glm::vec3& p, const glm::vec2& size) {
  const CameraFrame frame = cameraFrame(camera);
  const glm::vec3 way = p - camera.eye;
  float half = 0.5f * camera.heightMm;
  if (camera.projection == Projection::perspective) {
    const float depth = -glm::dot(way, frame.back);
    if (!(depth > 0.0f))
      return std::nullopt;
    half = depth * edgeSlope(camera);
  }
  const float scale = 0.5f * size.y / half;
  return 0.5f * size + scale * glm::vec2(glm::dot(way, frame.right), -glm::dot(way, frame.up));
}

Camera CameraDrag::at(const glm::vec2& pixel, const glm::vec2& size) const {
  const glm::vec2 way = pixel - m_start.pixel;
  if (m_start.kind == Kind::pan)
    return panned(m_start.camera, m_start.pivot, way, size.y);
  if (m_start.kind == Kind::zoom)
    return zoomedWithin(m_start.camera, m_start.pivot, std::pow(zoomPerHeight, -way.y / size.y),
                        m_start.ends);
  if (m_start.kind == Kind::roll) {
    const glm::vec2 from = m_start.pixel - 0.5f * size;
    const glm::vec2 to = pixel - 0.5f * size;
    const float across = from.x * to.y - from.y * to.x;
    return rolled(m_start.camera, glm::degrees(std::atan2(across, glm::dot(from, to))));
  }
  const float rate = degreesPerHeight / size.y;
  return orbited(m_start.camera, m_start.pivot, rate * way.x, rate * way.y);
}

}  // namespace sline::model
