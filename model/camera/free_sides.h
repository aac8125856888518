// SPDX-License-Identifier: Apache-2.0
// Fits a camera to a part of the picture, so that objects at the picture's sides keep their room.
#pragma once

#include "model/camera/camera.h"

namespace sline::model {

/// Says how much a fitted camera keeps free at each side, as shares of the picture's width or
/// height. Opposite sides together are less than 1.
struct FreeSides {
  double left = 0.05;
  double right = 0.05;
  double top = 0.05;
  double bottom = 0.05;
  bool operator==(const FreeSides&) const = default;
};

/// Fits the camera like `fitted` without sides, but centres the points in the area that the sides
/// leave, as large as possible. The camera is not turned; it moves sideways where opposite sides
/// differ.
Camera fitted(Camera camera, std::span<const glm::vec3> points, float aspect,
              const FreeSides& sides);

}  // namespace sline::model
