// SPDX-License-Identifier: Apache-2.0
// Describes the torus of tests/support/shapes.h in closed form: u runs around the ring, v around
// the tube.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace sline::test {

struct Torus {
  double major;
  double minor;

  struct Point {
    double u;
    double v;
  };

  glm::dvec3 position(Point p) const {
    const double r = major + minor * std::cos(p.v);
    return {r * std::cos(p.u), r * std::sin(p.u), minor * std::sin(p.v)};
  }
  glm::dvec3 normal(Point p) const {
    return {std::cos(p.v) * std::cos(p.u), std::cos(p.v) * std::sin(p.u), std::sin(p.v)};
  }
  glm::dvec3 alongRing(Point p) const { return {-std::sin(p.u), std::cos(p.u), 0.0}; }
  glm::dvec3 alongTube(Point p) const { return glm::cross(alongRing(p), normal(p)) * -1.0; }

  /// Returns the parameters of a point on (or near) the torus.
  Point at(const glm::dvec3& p) const {
    return {std::atan2(p.y, p.x), std::atan2(p.z, std::hypot(p.x, p.y) - major)};
  }

  /// Returns v̂ of a camera far away in this unit direction.
  double nv(Point p, const glm::dvec3& towardsEye) const { return glm::dot(normal(p), towardsEye); }
  /// Returns κr with ŵ normalised (METHOD §3).
  double radialCurvature(Point p, const glm::dvec3& towardsEye) const {
    const double ring = glm::dot(towardsEye, alongRing(p));
    const double tube = glm::dot(towardsEye, alongTube(p));
    const double kRing = std::cos(p.v) / (major + minor * std::cos(p.v));
    return (tube * tube / minor + ring * ring * kRing) / (tube * tube + ring * ring);
  }
  /// Returns the change of κr along ŵ, by central differences of the closed form.
  double radialCurvatureDerivative(Point p, const glm::dvec3& towardsEye) const {
    const double ring = glm::dot(towardsEye, alongRing(p));
    const double tube = glm::dot(towardsEye, alongTube(p));
    const double length = std::hypot(ring, tube);
    const double h = 1e-5;
    const Point step{h * ring / length / (major + minor * std::cos(p.v)),
                     h * tube / length / minor};
    const Point ahead{p.u + step.u, p.v + step.v};
    const Point behind{p.u - step.u, p.v - step.v};
    return (radialCurvature(ahead, towardsEye) - radialCurvature(behind, towardsEye)) / (2.0 * h);
  }
};

}  // namespace sline::test
