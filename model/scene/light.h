// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace sline::model {

/// The light comes from over the draughtsman's left shoulder, as plates of anatomy are lit; a unit
/// vector in the camera's frame (right, up, back).
inline constexpr glm::vec3 upperLeftLight{-0.538f, 0.606f, 0.586f};

/// The key light turns with the camera.
struct KeyLight {
  glm::vec3 towards = upperLeftLight;  ///< unit vector in the camera's frame
  bool shades = false;  ///< lights shading too, besides the light at the eye; else hatching alone
  std::string unread;   ///< like Node::unread
  bool operator==(const KeyLight&) const = default;
};

/// Returns what makes a light unusable, for an error message.
inline std::optional<std::string_view> lightFault(const KeyLight& light) {
  const float length = glm::length(light.towards);
  // NaN does not pass this comparison.
  return std::abs(length - 1.0f) < 1e-3f
             ? std::nullopt
             : std::optional<std::string_view>("the direction towards the light is no unit vector");
}

}  // namespace sline::model
