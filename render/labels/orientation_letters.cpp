// SPDX-License-Identifier: Apache-2.0
#include "render/labels/orientation_letters.h"

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>

namespace sline::render {

namespace {

/// The letters of +x, +y, +z and of −x, −y, −z in LPS.
constexpr char positive[] = "LPS";
constexpr char negative[] = "RAI";

/// Returns the sides that the direction leads to by more than sin 25°, the nearest first.
std::string sidesTowards(const glm::vec3& direction, const model::KnownSides& known) {
  constexpr float least = 0.42f;
  std::array<int, 3> axes{0, 1, 2};
  std::sort(axes.begin(), axes.end(),
            [&](int a, int b) { return std::abs(direction[a]) > std::abs(direction[b]); });
  std::string sides;
  for (const int axis : axes)
    if (std::abs(direction[axis]) > least) {
      sides += (direction[axis] > 0.0f ? positive : negative)[axis];
      if (known.inDoubt(axis))
        sides += '?';
    }
  return sides;
}

}  // namespace

EdgeLetters edgeLetters(const model::Camera& camera, const model::KnownSides& sides) {
  const model::CameraFrame frame = model::cameraFrame(camera);
  return {.left = sidesTowards(-frame.right, sides),
          .right = sidesTowards(frame.right, sides),
          .top = sidesTowards(frame.up, sides),
          .bottom = sidesTowards(-frame.up, sides)};
}

}  // namespace sline::render
