// SPDX-License-Identifier: Apache-2.0
// Moves cameras so that points fill their picture.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <span>
#include <vector>

#include "model/camera/camera.h"
#include "model/camera/camera_axes.h"
#include "model/camera/free_sides.h"
#include "model/camera/outermost_points.h"

namespace sline::model {

namespace {

/// Holds the extent of points along the camera's axes: right, up, back.
struct FittedExtent {
  CameraInterval right;
  CameraInterval up;
  CameraInterval back;
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

/// Holds the points whose slope from an eye may be the least or the greatest. As an eye moves
/// sideways each slope changes evenly, so a point that is behind another at both ends of the eye's
/// range is behind it throughout.
class Outermost {
 public:
  Outermost(std::span<const glm::dvec2> lateralAndDepth, double eyeDepth) {
    m_points.reserve(lateralAndDepth.size());
    for (const glm::dvec2& p : lateralAndDepth)
      m_points.push_back({p.x, eyeDepth - p.y});
  }

  /// Returns the least and the greatest slope.
  CameraInterval slopesFrom(double eye) {
    CameraInterval slopes;
    for (const Point& p : m_points) {
      const double slope = p.slopeFrom(eye);
      if (slope < slopes.low)
        m_least = p;
      if (slope > slopes.high)
        m_greatest = p;
      slopes.add(slope);
    }
    return slopes;
  }

  /// Drops the points that are not outermost from any eye between `low` and `high`, as far as those
  /// that were last can tell.
  void narrow(double low, double high) {
    constexpr std::size_t few = 64;
    if (m_points.size() <= few)
      return;
    constexpr double rounding = 1e-9;
    const std::array eyes{low, high};
    std::array<double, 2> least{};
    std::array<double, 2> greatest{};
    for (std::size_t i = 0; i < 2; ++i) {
      least[i] = m_least.slopeFrom(eyes[i]);
      greatest[i] = m_greatest.slopeFrom(eyes[i]);
      const double room = rounding * (1.0 + std::abs(least[i]) + std::abs(greatest[i]));
      least[i] += room;
      greatest[i] -= room;
    }
    std::erase_if(m_points, [&](const Point& p) {
      const double first = p.slopeFrom(low);
      const double second = p.slopeFrom(high);
      return (first > least[0] && second > least[1]) &&
             (first < greatest[0] && second < greatest[1]);
    });
  }

 private:
  struct Point {
    double lateral = 0.0;
    double away = 1.0;  ///< from the eye, along the line of sight
    double slopeFrom(double eye) const { return (lateral - eye) / away; }
  };
  std::vector<Point> m_points;
  Point m_least;
  Point m_greatest;
};

/// Returns the lateral eye position from which the outermost points on both sides lie equally far
/// from their ends of the picture; found by bisection, since the difference of the two falls
/// monotonically.
double centredEye(std::span<const glm::dvec2> lateralAndDepth, const CameraInterval& range,
                  double eyeDepth, const Slopes& allowed) {
  const double aside = allowed.high - allowed.low;
  double farthest = 0.0;
  for (const glm::dvec2& p : lateralAndDepth)
    farthest = std::max(farthest, eyeDepth - p.y);
  double low = range.low - std::max(aside, 0.0) * farthest;
  double high = range.high + std::max(-aside, 0.0) * farthest;
  Outermost outermost(lateralAndDepth, eyeDepth);
  for (int step = 0; step < 40 && low < high; ++step) {
    const double eye = 0.5 * (low + high);
    const CameraInterval slopes = outermost.slopesFrom(eye);
    (slopes.low + slopes.high > aside ? low : high) = eye;
    outermost.narrow(low, high);
  }
  return 0.5 * (low + high);
}

/// Returns the position of the eye in the camera's axes.
glm::dvec3 perspectiveFit(const std::vector<glm::dvec3>& points, const FittedExtent& extent,
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

  const auto flat = [&points](int lateral) {
    std::vector<glm::dvec2> seen;
    seen.reserve(points.size());
    for (const glm::dvec3& p : points)
      seen.emplace_back(p[lateral], p.z);
    return seen;
  };
  return {centredEye(flat(0), extent.right, depth, across),
          centredEye(flat(1), extent.up, depth, upwards), depth};
}

}  // namespace

Camera fitted(Camera camera, std::span<const glm::vec3> points, float aspect) {
  return fitted(camera, points, aspect, FreeSides());
}

Camera fitted(Camera camera, std::span<const glm::vec3> points, float aspect,
              const FreeSides& sides) {
  if (points.empty())
    return camera;
  const CameraAxes axes = axesOf(camera);
  const PointCloud cloud{points, Box{}};
  const std::vector<glm::vec3> outermost = outermostPoints(camera, std::span(&cloud, 1));
  std::vector<glm::dvec3> local(outermost.size());
  FittedExtent extent;
  for (std::size_t i = 0; i < outermost.size(); ++i) {
    const glm::dvec3 p(outermost[i]);
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

}  // namespace sline::model
