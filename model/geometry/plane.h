// SPDX-License-Identifier: Apache-2.0
// Defines a cutting plane; everything on the side to which its normal points is taken away.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <span>

namespace sline::model {

/// The plane is ⟨normal, p⟩ = offset and keeps ⟨normal, p⟩ ≤ offset, so the normal points out of
/// the cut face. Patient frame LPS.
struct Plane {
  glm::vec3 normal{0.0f, 0.0f, 1.0f};  ///< unit vector
  float offset = 0.0f;                 ///< mm from the origin along the normal

  /// Returns the signed distance in millimetres, positive on the side that is taken away.
  double distance(const glm::vec3& p) const {
    return glm::dot(glm::dvec3(normal), glm::dvec3(p)) - double(offset);
  }
  bool keeps(const glm::vec3& p) const { return !(distance(p) > 0.0); }
  bool operator==(const Plane&) const = default;
};

/// Tells whether all planes keep the point.
inline bool keptByAll(std::span<const Plane> planes, const glm::vec3& p) {
  return std::all_of(planes.begin(), planes.end(), [&](const Plane& c) { return c.keeps(p); });
}

/// Two unit vectors span the plane, with u × v = normal; v is as upright (+z, then −y) as it can
/// be.
struct PlaneAxes {
  glm::dvec3 u;
  glm::dvec3 v;
};
inline PlaneAxes axesOf(const Plane& plane) {
  const glm::dvec3 n(plane.normal);
  const glm::dvec3 upright = std::abs(n.z) > 0.9 ? glm::dvec3(0.0, -1.0, 0.0) : glm::dvec3(0, 0, 1);
  const glm::dvec3 u = glm::normalize(glm::cross(upright, n));
  return {u, glm::cross(n, u)};
}

}  // namespace sline::model
