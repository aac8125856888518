// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <span>

#include "render/sight/rules.h"

namespace sline::render {

/// Tells whether one of the planes, each (unit normal, −offset), takes the place away.
inline bool isCutAway(std::span<const glm::vec4> planes, const glm::vec3& place) {
  return std::any_of(planes.begin(), planes.end(),
                     [&place](const glm::vec4& plane) { return rule::takesAway(plane, place); });
}

}  // namespace sline::render
