// SPDX-License-Identifier: Apache-2.0
// Tells which part of space a picture can show.
#pragma once

#include <array>

#include "model/camera/camera.h"
#include "model/geometry/mesh.h"

namespace sline::render {

class Frustum {
 public:
  /// Bounds what a picture shows that is `aspect` times as wide as high.
  Frustum(const model::Camera& camera, float aspect);
  /// Tells whether no part of the sphere can be seen.
  bool misses(const model::Sphere& sphere) const;

 private:
  struct Side {
    glm::vec3 outwards{0.0f};  ///< unit
    float offset = 0.0f;       ///< mm
  };
  std::array<Side, 5> m_sides;  ///< four sides and, in perspective, the eye's plane
};

}  // namespace sline::render
