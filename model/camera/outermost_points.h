// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "model/camera/camera.h"
#include "model/geometry/mesh.h"

namespace sline::model {

/// Points in millimetres, and a box that holds them all.
struct PointCloud {
  std::span<const glm::vec3> points;
  Box box;
};

/// Returns those of the clouds' points that a camera of this direction may have to move for: the
/// others lie within the outline of these, as one looks along the camera's right axis and as one
/// looks along its up axis, so that from no eye and at no distance they are outermost.
std::vector<glm::vec3> outermostPoints(const Camera& camera, std::span<const PointCloud> clouds);

}  // namespace sline::model
