// SPDX-License-Identifier: Apache-2.0
#include "model/camera/outermost_points.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <mutex>

#include "model/base/parallel.h"
#include "model/camera/camera_axes.h"

namespace sline::model {

namespace {

/// The octagon of the outermost of some points in eight directions: what lies within is not on
/// their hull (S. Akl, G. Toussaint, "A Fast Convex Hull Algorithm", 1978).
class Octagon {
 public:
  explicit Octagon(std::span<const glm::dvec2> points) {
    std::array<glm::dvec2, sides> corners;
    corners.fill(points.front());
    std::array<double, sides> farthest = along(points.front());
    for (const glm::dvec2& p : points) {
      const std::array<double, sides> here = along(p);
      for (std::size_t i = 0; i < sides; ++i)
        if (here[i] > farthest[i]) {
          farthest[i] = here[i];
          corners[i] = p;
        }
    }
    const double size = std::max(farthest[0] + farthest[4], farthest[2] + farthest[6]);
    m_rounding = 1e-9 * size * size;
    for (std::size_t i = 0; i < sides; ++i) {
      const glm::dvec2& a = corners[i];
      const glm::dvec2 side = corners[(i + 1) % sides] - a;
      m_x[i] = -side.y;
      m_y[i] = side.x;
      // One without length, of points that are not all at one place, is no side.
      const bool none = side.x == 0.0 && side.y == 0.0 && size > 0.0;
      m_from[i] = none ? std::numeric_limits<double>::infinity() : side.y * a.x - side.x * a.y;
    }
  }

  bool holds(const glm::dvec2& p) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < sides; ++i)
      least = std::min(least, m_x[i] * p.x + m_y[i] * p.y + m_from[i]);
    return least > m_rounding;
  }

 private:
  static constexpr std::size_t sides = 8;
  static std::array<double, sides> along(const glm::dvec2& p) {
    return {p.x, p.x + p.y, p.y, p.y - p.x, -p.x, -p.x - p.y, -p.y, p.x - p.y};
  }
  std::array<double, sides> m_x{};
  std::array<double, sides> m_y{};
  std::array<double, sides> m_from{};
  double m_rounding = 0.0;
};

/// What surely lies within all, seen along two of a camera's axes.
class Inside {
 public:
  Inside(const CameraAxes& axes, std::span<const glm::vec3> some)
      : m_axes(axes),
        m_across(seen(some, &CameraAxes::right)),
        m_upwards(seen(some, &CameraAxes::up)) {}

  bool holds(const glm::vec3& point) const {
    return m_across.holds(flat(point, &CameraAxes::right)) &&
           m_upwards.holds(flat(point, &CameraAxes::up));
  }
  /// A convex outline that holds a box's corners holds all of it.
  bool holds(const Box& box) const {
    const auto corners = box.corners();
    return !box.empty() && std::all_of(corners.begin(), corners.end(),
                                       [this](const glm::vec3& p) { return holds(p); });
  }

 private:
  using Axis = glm::dvec3 CameraAxes::*;
  glm::dvec2 flat(const glm::vec3& point, Axis axis) const {
    const glm::dvec3 p(point);
    return {glm::dot(p, m_axes.*axis), glm::dot(p, m_axes.back)};
  }
  std::vector<glm::dvec2> seen(std::span<const glm::vec3> points, Axis axis) const {
    std::vector<glm::dvec2> all;
    all.reserve(points.size());
    for (const glm::vec3& p : points)
      all.push_back(flat(p, axis));
    return all;
  }

  CameraAxes m_axes;
  Octagon m_across;
  Octagon m_upwards;
};

/// Returns some thousand of the points, from all over the clouds.
std::vector<glm::vec3> someOf(std::span<const PointCloud> clouds) {
  constexpr std::size_t enough = 4096;
  std::size_t count = 0;
  for (const PointCloud& cloud : clouds)
    count += cloud.points.size();
  const std::size_t step = 1 + count / enough;
  std::vector<glm::vec3> some;
  some.reserve(enough);
  std::size_t next = 0;  // of this cloud
  for (const PointCloud& cloud : clouds) {
    for (; next < cloud.points.size(); next += step)
      some.push_back(cloud.points[next]);
    next -= cloud.points.size();
  }
  return some;
}

}  // namespace

std::vector<glm::vec3> outermostPoints(const Camera& camera, std::span<const PointCloud> clouds) {
  constexpr std::size_t grain = 8192;
  const std::vector<glm::vec3> some = someOf(clouds);
  if (some.empty())
    return {};
  const Inside inside(axesOf(camera), some);
  std::vector<glm::vec3> outermost;
  std::mutex mutex;
  parallelFor(clouds.size(), 16, [&](std::size_t i) {
    if (inside.holds(clouds[i].box))
      return;
    parallelChunks(clouds[i].points.size(), grain, [&](std::size_t begin, std::size_t end) {
      std::vector<glm::vec3> here;
      for (const glm::vec3& point : clouds[i].points.subspan(begin, end - begin))
        if (!inside.holds(point))
          here.push_back(point);
      const std::lock_guard lock(mutex);
      outermost.insert(outermost.end(), here.begin(), here.end());
    });
  });
  return outermost;
}

}  // namespace sline::model
