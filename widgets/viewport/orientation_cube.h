// SPDX-License-Identifier: Apache-2.0
// Computes the body's six sides as a cube that turns with the scene. Geometry without a window;
// pixels count from the cube's middle, y downwards.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "model/camera/camera.h"

namespace sline::widgets {

/// A face, an edge or a corner, by the direction (LPS) in which it lies: each coordinate is −1, 0
/// or 1, and not all are 0.
using CubeDirection = glm::ivec3;

/// A face as it is seen. Its letter is read upright where `right` leads to the right and `up`
/// upwards.
struct CubeFace {
  char letter = 'A';
  CubeDirection part{0};
  glm::vec2 centre{0.0f};
  glm::vec2 right{0.0f};  ///< from the middle to the right edge
  glm::vec2 up{0.0f};     ///< from the middle to the upper edge
  float facing = 0.0f;    ///< 1 where it looks straight at the eye, 0 edge-on
  std::array<glm::vec2, 4> corners() const;
};

/// Returns the axis along which a face lies, for what has no sides: "X", "−X" … (UTF-8).
std::string axisOf(const CubeDirection& face);
/// Returns the faces that look at the eye; `half` is half the cube's edge in pixels.
std::vector<CubeFace> cubeFaces(const model::Camera& camera, float half);
/// Returns the outline of a part on the faces that show it.
std::vector<std::array<glm::vec2, 4>> cubePatches(const std::vector<CubeFace>& faces,
                                                  const CubeDirection& part);
/// Returns the part of the cube that is at a pixel; absent beside the cube.
std::optional<CubeDirection> cubeDirectionAt(const std::vector<CubeFace>& faces,
                                             const glm::vec2& pixel);
/// Returns the direction that points upwards in the picture for a view of that part: the head, and
/// from straight above or below the front of the body.
glm::vec3 upwardsFrom(const CubeDirection& part);

}  // namespace sline::widgets
