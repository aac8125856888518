// SPDX-License-Identifier: Apache-2.0
#include "model/scene/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>
#include <utility>
#include <vector>

#include "model/scene/free_sides.h"

namespace sline::model {

namespace {

/// With the eye inside the box, the near plane stands at this fraction of the far plane's distance:
/// 1 in 4096 leaves 12 of a 24-bit depth buffer's bits at the far end.
constexpr double nearestShare = 1.0 / 4096.0;

struct Axes {
  glm::dvec3 right;
  glm::dvec3 up;
  glm::dvec3 back;
};

/// Returns the axes in double precision, so that a scene a billion times smaller gives the same
/// picture.
Axes axesOf(const Camera& camera) {
  const glm::dvec3 back = glm::normalize(glm::dvec3(camera.eye) - glm::dvec3(camera.target));
  const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(camera.up), back));
  return {right, glm::cross(back, right), back};
}

double halfTangent(const Camera& camera) {
  constexpr double radiansPerDegree = 3.14159265358979323846 / 180.0;
  return std::tan(0.5 * double(camera.fovyDegrees) * radiansPerDegree);
}

struct Interval {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  double middle() const { return 0.5 * (low + high); }
  double length() const { return high - low; }
};

/// Holds the extent of points along the camera's axes: right, up, back.
struct Extent {
  Interval right;
  Interval up;
  Interval back;
  double size() const { return std::max({right.length(), up.length(), back.length()}); }
};

/// Says how far points may lie from the line of sight per unit of depth from the eye, towards
/// smaller and towards larger coordinates. One of the two may be negative.
struct Slopes {
  double low;
  double high;
};

/// Returns the slopes between the shares `low` and `high` of a picture; `tangent` is that of half
/// its opening angle.
Slopes slopesWithin(double tangent, double low, double high) {
  return {(1.0 - 2.0 * low) * tangent, (1.0 - 2.0 * high) * tangent};
}

/// Fits one axis of a perspective. A point at (lateral r, depth b) is seen from an eye at (er, eb)
/// where r − er ≤ high·(eb − b) and er − r ≤ low·(eb − b): each point gives two half-planes, of
/// which only the outermost count.
struct Support {
  Slopes slopes;
  double above = -std::numeric_limits<double>::infinity();  ///< max of r + high·b
  double below = -std::numeric_limits<double>::infinity();  ///< max of −r + low·b
  void add(double lateral, double depth) {
    above = std::max(above, lateral + slopes.high * depth);
    below = std::max(below, -lateral + slopes.low * depth);
  }
  double nearestEye() const { return (above + below) / (slopes.low + slopes.high); }
};

/// Returns the lateral eye position from which the outermost points on both sides lie equally far
/// from their ends of the picture; found by bisection, since the difference of the two falls
/// monotonically.
double centredEye(std::span<const glm::dvec2> lateralAndDepth, const Interval& range,
                  double eyeDepth, const Slopes& allowed) {
  const double aside = allowed.high - allowed.low;
  double farthest = 0.0;
  for (const glm::dvec2& p : lateralAndDepth)
    farthest = std::max(farthest, eyeDepth - p.y);
  double low = range.low - std::max(aside, 0.0) * farthest;
  double high = range.high + std::max(-aside, 0.0) * farthest;
  for (int step = 0; step < 40 && low < high; ++step) {
    const double eye = 0.5 * (low + high);
    Interval slopes;
    for (const glm::dvec2& p : lateralAndDepth)
      slopes.add((p.x - eye) / (eyeDepth - p.y));
    (slopes.low + slopes.high > aside ? low : high) = eye;
  }
  return 0.5 * (low + high);
}

/// Returns the position of the eye in the camera's axes.
glm::dvec3 perspectiveFit(const std::vector<glm::dvec3>& points, const Extent& extent,
                          const Slopes& across, const Slopes& upwards) {
  Support horizontal{across};
  Support vertical{upwards};
  for (const glm::dvec3& p : points) {
    horizontal.add(p.x, p.z);
    vertical.add(p.y, p.z);
  }
  // This keeps the eye out of the points where they form a needle along the line of sight.
  const double clear = extent.back.high + 1e-3 * extent.size();
  const double depth = std::max({horizontal.nearestEye(), vertical.nearestEye(), clear});

  std::vector<glm::dvec2> lateral(points.size());
  std::transform(points.begin(), points.end(), lateral.begin(),
                 [](const glm::dvec3& p) { return glm::dvec2(p.x, p.z); });
  const double right = centredEye(lateral, extent.right, depth, across);
  std::transform(points.begin(), points.end(), lateral.begin(),
                 [](const glm::dvec3& p) { return glm::dvec2(p.y, p.z); });
  return {right, centredEye(lateral, extent.up, depth, upwards), depth};
}

/// Returns near and far along the line of sight, a little outside the box.
Interval depthRange(const Camera& camera, const Box& bounds) {
  const Axes axes = axesOf(camera);
  const glm::dvec3 eye(camera.eye);
  const double focus = glm::length(eye - glm::dvec3(camera.target));
  Interval depth;
  if (bounds.empty()) {
    depth.add(0.0);
    depth.add(2.0 * focus);
  } else {
    for (const glm::vec3& corner : bounds.corners())
      depth.add(glm::dot(eye - glm::dvec3(corner), axes.back));
  }
  // The last term keeps rounding from clipping a flat box; it grows with the coordinates.
  const double room = 1e-3 * depth.length() + 1e-5 * (std::abs(depth.middle()) + focus);
  Interval range{depth.low - room, depth.high + room};
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

Camera fitted(Camera camera, std::span<const glm::vec3> points, float aspect) {
  return fitted(camera, points, aspect, FreeSides());
}

Camera fitted(Camera camera, std::span<const glm::vec3> points, float aspect,
              const FreeSides& sides) {
  if (points.empty())
    return camera;
  const Axes axes = axesOf(camera);
  std::vector<glm::dvec3> local(points.size());
  Extent extent;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const glm::dvec3 p(points[i]);
    local[i] = {glm::dot(p, axes.right), glm::dot(p, axes.up), glm::dot(p, axes.back)};
    extent.right.add(local[i].x);
    extent.up.add(local[i].y);
    extent.back.add(local[i].z);
  }

  const double focus = glm::length(glm::dvec3(camera.eye) - glm::dvec3(camera.target));
  glm::dvec3 eye(extent.right.middle(), extent.up.middle(), extent.back.middle() + focus);
  if (camera.projection == Projection::orthographic) {
    const double height =
        std::max(extent.up.length() / (1.0 - sides.top - sides.bottom),
                 extent.right.length() / double(aspect) / (1.0 - sides.left - sides.right));
    if (height > 0.0) {
      camera.heightMm = float(height);
      eye.x -= 0.5 * height * double(aspect) * (sides.left - sides.right);
      eye.y -= 0.5 * height * (sides.bottom - sides.top);
    }
    if (extent.size() > 0.0)
      eye.z = extent.back.high + extent.size();
  } else if (extent.size() > 0.0) {
    const double tangent = halfTangent(camera);
    eye = perspectiveFit(local, extent,
                         slopesWithin(tangent * double(aspect), sides.left, sides.right),
                         slopesWithin(tangent, sides.bottom, sides.top));
  }
  const auto world = [&axes](const glm::dvec3& p) {
    return glm::vec3(p.x * axes.right + p.y * axes.up + p.z * axes.back);
  };
  camera.target = world({eye.x, eye.y, extent.back.middle()});
  camera.eye = world(eye);
  return camera;
}

CameraFrame cameraFrame(const Camera& camera) {
  const Axes axes = axesOf(camera);
  return {glm::vec3(axes.right), glm::vec3(axes.up), glm::vec3(axes.back)};
}

glm::mat4 viewMatrix(const Camera& camera) {
  const Axes axes = axesOf(camera);
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
  const Interval depth = depthRange(camera, bounds);
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
  const glm::dvec3 eye(camera.eye);
  const glm::dvec3 target(camera.target);
  const double distance = glm::length(eye - target);
  // At a distance below the coordinates' own rounding, the direction would be noise.
  if (!(distance > 1e-6 * std::max(glm::length(eye), glm::length(target))))
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
  return std::nullopt;
}

}  // namespace sline::model
