// SPDX-License-Identifier: Apache-2.0
// Converts depths of the window to distances, as depth.glsl does for shaders. `projection` holds
// the projection matrix' [2][2], [3][2], [2][3] and [3][3] (see PictureView::depthTerms).
#pragma once

#include <algorithm>
#include <glm/vec4.hpp>

namespace sline::render {

/// Returns the distance in millimetres from the eye's plane to a window depth, 0 … 1.
inline float eyeDistance(float windowDepth, const glm::vec4& projection) {
  const float z = 2.0f * windowDepth - 1.0f;
  return (projection.y - z * projection.w) / (projection.x - z * projection.z);
}

/// Returns by how much window depth falls where a point comes nearer to the eye by so many
/// millimetres.
inline float depthLift(float windowDepth, float mm, const glm::vec4& projection) {
  const float from = eyeDistance(windowDepth, projection);
  float to = from - mm;
  if (projection.z != 0.0f)
    to = std::max(to, 1e-3f * from);  // in perspective not behind the eye
  const float z = (projection.y - to * projection.x) / (projection.w - to * projection.z);
  return windowDepth - (0.5f * z + 0.5f);
}

}  // namespace sline::render
