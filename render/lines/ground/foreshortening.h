// SPDX-License-Identifier: Apache-2.0
// Tells how close strokes on a surface come to each other in a picture where it turns away.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace sline::render {

/// Returns the share of the distance between strokes that is seen. `along` is a stroke's direction,
/// of any length; where it has none, the mean over all directions is returned.
inline float seenAcross(float nv, const glm::vec3& along, const glm::vec3& toEye) {
  const float length = glm::length(along);
  if (!(length > 0.0f))
    return std::sqrt(std::max(nv, 0.0f));
  // A square on the surface with one side along the stroke is seen with nv of its area, and the
  // stroke's side is seen as long as its direction lies across the view: the rest is its other
  // side.
  const float towards = glm::dot(along, toEye) / length;
  return nv / std::sqrt(std::max({1.0f - towards * towards, nv * nv, 1e-12f}));
}

/// Turns that share into the one that decides which levels of strokes show: its root, half as fast
/// in powers of two, as strokes that left as fast as the surface turns away would come and go with
/// every turn; but in the depth of a tunnel, where less than `deep` is seen and that would turn
/// black, all of it.
inline float widened(float across, float deep) {
  return across >= deep ? std::sqrt(across) : across / std::sqrt(deep);
}

}  // namespace sline::render
