// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <concepts>

namespace sline {

/// Returns the amount of light, 0 to 1, for which a value of sRGB from 0 to 1 stands
/// (IEC 61966-2-1).
template <std::floating_point Number>
Number lightFromSrgb(Number value) {
  return value <= Number(0.04045) ? value / Number(12.92)
                                  : std::pow((value + Number(0.055)) / Number(1.055), Number(2.4));
}

/// Returns the value of sRGB, 0 to 1, for an amount of light from 0 to 1; the inverse of
/// `lightFromSrgb`.
template <std::floating_point Number>
Number srgbFromLight(Number light) {
  return light <= Number(0.0031308)
             ? Number(12.92) * light
             : Number(1.055) * std::pow(light, Number(1) / Number(2.4)) - Number(0.055);
}

}  // namespace sline
