// SPDX-License-Identifier: Apache-2.0
// Looks whether a contour is in sight of the eye, past its own surface, as sight.frag.glsl does.
#pragma once

#include <optional>

#include "render/sight/rules.h"

namespace sline::render {

/// A place of a contour. Depths may be window depths or distances from the eye.
struct ContourPlace {
  float depth = 0.0f;
  float tolerance = 0.0f;  ///< a surface that is nearer by less hides nothing
  float sheet = 0.0f;      ///< by so much its own sheet may hide it
  glm::vec2 reach{0.0f};   ///< pixels outside at which it is looked for: a small and a wide step
};

/// Returns which look saw the contour; nothing where it is hidden. `surfaceAt(outside)` returns how
/// deep its structure's surface lies so many pixels outside the contour.
template <class SurfaceAt>
std::optional<int> contourLook(const ContourPlace& place, const SurfaceAt& surfaceAt) {
  float here = 0.0f;
  for (int k = 0; k < rule::lookedEnough;) {
    const float surface = surfaceAt(rule::lookOutside(k, place.reach));
    here = k == 0 ? surface : here;
    const int after =
        rule::afterLook(k, surface, place.depth, here, {place.tolerance, place.sheet});
    if (after == rule::lineSeen)
      return k;
    k = after;
  }
  return std::nullopt;
}

}  // namespace sline::render
