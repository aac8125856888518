// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>

namespace sline::render {

/// Describes a line around marked structures, of which a Gaussian over the pixels around tells how
/// far each pixel is from the border; lengths in pixels.
struct OutlineLook {
  glm::vec3 ink{0.0f};
  glm::vec3 casing{1.0f};  ///< beside the ink, to set it off from what is there
  float halfWidth = 1.0f;
  float casingHalfWidth = 2.0f;
  float strength = 1.0f;  ///< 0 … 1
  float hiddenStrength = 0.3f;

  /// Returns the Gaussian's standard deviation, which tells distances up to the casing's rim: the
  /// share of like pixels is of no use beyond 1.25 of it.
  float scale() const { return std::max(1.0f, (casingHalfWidth + 0.5f) / 1.2f); }
  /// Returns how many pixels each way are looked at, which the line can touch beside a structure.
  int reach() const { return std::min(mostReach, int(std::ceil(2.0f * scale()))); }

  bool operator==(const OutlineLook&) const = default;

  static constexpr int mostReach = 12;
};

}  // namespace sline::render
