// SPDX-License-Identifier: Apache-2.0
// What of space a picture can show.
#pragma once

#include <array>

#include "model/geometry/mesh.h"
#include "model/scene/camera.h"

namespace sline::render {

class Frustum {
 public:
  /// Of a picture `aspect` times as wide as high.
  Frustum(const model::Camera& camera, float aspect);
  /// True where nothing of the sphere can be seen.
  bool misses(const model::Sphere& sphere) const;

 private:
  struct Side {
    glm::vec3 outwards{0.0f};  ///< unit
    float offset = 0.0f;       ///< mm
  };
  std::array<Side, 5> m_sides;  ///< four and, in perspective, the eye's plane
};

}  // namespace sline::render
