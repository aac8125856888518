// SPDX-License-Identifier: Apache-2.0
#include "model/camera/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>
#include <utility>
#include <vector>

#include "model/camera/camera_axes.h"
#include "model/geometry/scale_limits.h"

namespace sline::model {

namespace {

/// With the eye inside the box, the near plane stands at this fraction of the far plane's distance:
/// 1 in 4096 leaves 12 of a 24-bit depth buffer's bits at the far end.
constexpr double nearestShare = 1.0 / 4096.0;

/// Returns near and far along the line of sight, a little outside the box.
CameraInterval depthRange(const Camera& camera, const Box& bounds) {
  const CameraAxes axes = axesOf(camera);
  const glm::dvec3 eye(camera.eye);
  const double focus = glm::length(eye - glm::dvec3(camera.target));
  CameraInterval depth;
  if (bounds.empty()) {
    depth.add(0.0);
    depth.add(2.0 * focus);
  } else {
    for (const glm::vec3& corner : bounds.corners())
      depth.add(glm::dot(eye - glm::dvec3(corner), axes.back));
  }
  // The last term keeps rounding from clipping a flat box; it grows with the coordinates.
  const double room = 1e-3 * depth.length() + 1e-5 * (std::abs(depth.middle()) + focus);
  CameraInterval range{depth.low - room, depth.high + room};
  if (camera.projection == Projection::perspective) {
    if (range.high <= 0.0)  // the whole box lies behind the eye: nothing to see, but a valid matrix
      range.high = focus;
    range.low = std::max(range.low, nearestShare * range.high);
  }
  return range;
}

bool finite(const glm::vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// At a length below this share of the coordinates, these are rounded too coarsely.
constexpr double leastShare = 1e-6;

double farthestCoordinateOf(const Camera& camera) {
  const auto farthest = [](const glm::vec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  };
  return double(std::max(farthest(camera.eye), farthest(camera.target)));
}

struct Direction {
  glm::vec3 towardsEye;
  glm::vec3 up;
};

Direction directionOf(AnatomicalView view) {
  constexpr glm::vec3 left(1.0f, 0.0f, 0.0f);
  constexpr glm::vec3 posterior(0.0f, 1.0f, 0.0f);
  constexpr glm::vec3 superior(0.0f, 0.0f, 1.0f);
  switch (view) {
    case AnatomicalView::anterior:
      return {-posterior, superior};
    case AnatomicalView::posterior:
      return {posterior, superior};
    case AnatomicalView::left:
      return {left, superior};
    case AnatomicalView::right:
      return {-left, superior};
    case AnatomicalView::superior:
      return {superior, -posterior};
    case AnatomicalView::inferior:
      return {-superior, -posterior};
  }
  return {-posterior, superior};
}

}  // namespace

std::optional<AnatomicalView> anatomicalViewNamed(std::string_view name) {
  const auto found = std::find(anatomicalViewNames.begin(), anatomicalViewNames.end(), name);
  if (found == anatomicalViewNames.end())
    return std::nullopt;
  return AnatomicalView(found - anatomicalViewNames.begin());
}

Camera anatomicalCamera(AnatomicalView view, const Box& bounds, float aspect) {
  const Direction direction = directionOf(view);
  Camera camera;
  camera.up = direction.up;
  const float distance = glm::length(camera.eye - camera.target);
  camera.eye = camera.target + distance * direction.towardsEye;
  if (bounds.empty())
    return camera;
  const auto corners = bounds.corners();
  return fitted(camera, corners, aspect);
}

AnatomicalView nearestAnatomicalView(const Camera& camera) {
  const glm::vec3 back = cameraFrame(camera).back;
  const auto seen = [&back](AnatomicalView view) {
    return glm::dot(back, directionOf(view).towardsEye);
  };
  AnatomicalView nearest = AnatomicalView::anterior;
  for (std::size_t i = 1; i < anatomicalViewNames.size(); ++i)
    if (seen(AnatomicalView(i)) > seen(nearest))
      nearest = AnatomicalView(i);
  return nearest;
}

std::optional<AnatomicalView> anatomicalViewOf(const Camera& camera) {
  constexpr float nearly = 0.9999f;  // within 0.8°
  const AnatomicalView nearest = nearestAnatomicalView(camera);
  const Direction direction = directionOf(nearest);
  const CameraFrame frame = cameraFrame(camera);
  const bool along = glm::dot(frame.back, direction.towardsEye) > nearly;
  return along && glm::dot(frame.up, direction.up) > nearly ? std::optional(nearest) : std::nullopt;
}

CameraFrame cameraFrame(const Camera& camera) {
  const CameraAxes axes = axesOf(camera);
  return {glm::vec3(axes.right), glm::vec3(axes.up), glm::vec3(axes.back)};
}

glm::mat4 viewMatrix(const Camera& camera) {
  const CameraAxes axes = axesOf(camera);
  const glm::dvec3 eye(camera.eye);
  glm::dmat4 view(1.0);
  const std::array<glm::dvec3, 3> rows{axes.right, axes.up, axes.back};
  for (int row = 0; row < 3; ++row) {
    const glm::dvec3& axis = rows[std::size_t(row)];
    for (int column = 0; column < 3; ++column)
      view[column][row] = axis[column];
    view[3][row] = -glm::dot(axis, eye);
  }
  return {view};
}

glm::mat4 projectionMatrix(const Camera& camera, const Box& bounds, float aspect) {
  const CameraInterval depth = depthRange(camera, bounds);
  const double span = depth.length();
  glm::dmat4 projection(0.0);
  if (camera.projection == Projection::orthographic) {
    projection[0][0] = 2.0 / (double(camera.heightMm) * double(aspect));
    projection[1][1] = 2.0 / double(camera.heightMm);
    projection[2][2] = -2.0 / span;
    projection[3][2] = -(depth.high + depth.low) / span;
    projection[3][3] = 1.0;
  } else {
    const double tangent = halfTangent(camera);
    projection[0][0] = 1.0 / (tangent * double(aspect));
    projection[1][1] = 1.0 / tangent;
    projection[2][2] = -(depth.high + depth.low) / span;
    projection[2][3] = -1.0;
    projection[3][2] = -2.0 * depth.high * depth.low / span;
  }
  return {projection};
}

glm::vec3 towardsEye(const Camera& camera, const glm::vec3& p) {
  const glm::dvec3 towards = glm::dvec3(camera.eye) - glm::dvec3(p);
  if (camera.projection == Projection::orthographic || glm::dot(towards, towards) == 0.0)
    return glm::vec3(axesOf(camera).back);
  return glm::vec3(glm::normalize(towards));
}

float edgeSlope(const Camera& camera) {
  return std::tan(0.5f * glm::radians(camera.fovyDegrees));
}

float millimetresPerPixel(const Camera& camera, const glm::vec3& p, float heightPixels) {
  if (camera.projection == Projection::orthographic)
    return camera.heightMm / heightPixels;
  const double depth = glm::dot(glm::dvec3(camera.eye) - glm::dvec3(p), axesOf(camera).back);
  return float(2.0 * std::max(depth, 0.0) * halfTangent(camera) / double(heightPixels));
}

std::optional<std::string_view> cameraFault(const Camera& camera) {
  if (!finite(camera.eye) || !finite(camera.target) || !finite(camera.up))
    return "a coordinate of eye, target or up is not a finite number";
  if (farthestCoordinateOf(camera) > double(farthestEye))
    return "eye or target lies more than 100,000 km away";
  const glm::dvec3 eye(camera.eye);
  const glm::dvec3 target(camera.target);
  const double distance = glm::length(eye - target);
  const double least = leastShare * std::max(glm::length(eye), glm::length(target));
  if (!(distance > least))  // the direction would be noise
    return "eye and target are the same point";
  const double upLength = glm::length(glm::dvec3(camera.up));
  if (!(upLength > 0.0))
    return "up has no length";
  const glm::dvec3 sight = (eye - target) / distance;
  if (!(glm::length(glm::cross(sight, glm::dvec3(camera.up) / upLength)) > 1e-4))
    return "up is parallel to the line of sight";
  if (camera.projection == Projection::perspective &&
      !(camera.fovyDegrees >= 1.0f && camera.fovyDegrees <= 170.0f))
    return "the opening angle is not between 1 and 170 degrees";
  if (camera.projection == Projection::orthographic &&
      !(std::isfinite(camera.heightMm) && camera.heightMm > 0.0f))
    return "the height is not a positive number of millimetres";
  if (camera.projection == Projection::orthographic &&
      !(double(camera.heightMm) > least && camera.heightMm <= farthestEye))
    return "the height is too small or too large for where eye and target lie";
  return std::nullopt;
}

}  // namespace sline::model
