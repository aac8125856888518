// SPDX-License-Identifier: Apache-2.0
// Says how far from the origin things may lie and how large a body is. Computations take
// coordinates to the fourth power, so that floats hold them only within these bounds.
#pragma once

#include <algorithm>

#include "model/geometry/mesh.h"

namespace sline::model {

/// No coordinate of a surface lies farther than this from the origin: 100 km.
inline constexpr float farthestCoordinate = 1e8f;
/// No coordinate of a camera does. A surface that fills the picture under the smallest opening
/// angle is seen from nearer.
inline constexpr float farthestEye = 1e11f;
/// A body, or a part of one, is no smaller and no larger than this, mm. Others are drawn, but their
/// unit is in doubt.
inline constexpr float smallestBody = 1e-4f;
inline constexpr float largestBody = 1e5f;

/// Tells whether something in that box may be a body or a part of one. What is empty or has no size
/// at all is not in doubt for its unit.
inline bool isPlausibleSize(const Box& box) {
  if (box.empty())
    return true;
  const glm::vec3 size = box.size();
  const float across = std::max({size.x, size.y, size.z});
  return across == 0.0f || (across >= smallestBody && across <= largestBody);
}

}  // namespace sline::model
