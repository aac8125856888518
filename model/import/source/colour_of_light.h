// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>

#include "model/base/srgb.h"
#include "model/base/units.h"

namespace sline::model {

/// Converts amounts of light, 0 … 1 each, in which formats made for renderers give colours of
/// materials, through the sRGB transfer function (IEC 61966-2-1). A value that is no number counts
/// as no light.
inline Colour colourOfLight(const glm::dvec3& linear) {
  const auto encoded = [](double light) {
    const double c = std::isnan(light) ? 0.0 : std::clamp(light, 0.0, 1.0);
    return std::uint8_t(std::lround(255.0 * srgbFromLight(c)));
  };
  return {encoded(linear.x), encoded(linear.y), encoded(linear.z)};
}

}  // namespace sline::model
