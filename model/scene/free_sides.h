// SPDX-License-Identifier: Apache-2.0
// Fitting a camera to a part of the picture: what stands at the picture's sides keeps its room.
#pragma once

#include "model/scene/camera.h"

namespace sline::model {

/// What a fitted camera keeps free at each side, as shares of the picture's width or height.
/// Opposite ones together are less than 1.
struct FreeSides {
  double left = 0.05;
  double right = 0.05;
  double top = 0.05;
  double bottom = 0.05;
  bool operator==(const FreeSides&) const = default;
};

/// As `fitted` without them: the points are centred in what the sides leave, as large as it lets
/// them be. The camera is not turned; it stands aside where opposite sides differ.
Camera fitted(Camera camera, std::span<const glm::vec3> points, float aspect,
              const FreeSides& sides);

}  // namespace sline::model
