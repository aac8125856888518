// SPDX-License-Identifier: Apache-2.0
#include "model/base/contrast.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "model/base/srgb.h"

namespace sline {

namespace {

double lightOf(std::uint8_t value) {
  return lightFromSrgb(double(value) / 255.0);
}

/// Mixes light: 0 leaves the colour, 1 makes it black or white.
Colour mixed(const Colour& colour, double towards, double share) {
  const auto channel = [&](std::uint8_t value) {
    const double light = (1.0 - share) * lightOf(value) + share * towards;
    return std::uint8_t(std::lround(255.0 * std::clamp(srgbFromLight(light), 0.0, 1.0)));
  };
  return {channel(colour.red), channel(colour.green), channel(colour.blue)};
}

}  // namespace

double luminanceOf(const Colour& colour) {
  return 0.2126 * lightOf(colour.red) + 0.7152 * lightOf(colour.green) +
         0.0722 * lightOf(colour.blue);
}

double contrastBetween(const Colour& a, const Colour& b) {
  const auto [low, high] = std::minmax({luminanceOf(a), luminanceOf(b)});
  return (high + 0.05) / (low + 0.05);
}

Colour legibleOn(const Colour& ground, const Colour& colour, double ratio) {
  if (contrastBetween(ground, colour) >= ratio)
    return colour;
  // The luminance at which black and white stand out alike.
  constexpr double middle = 0.179;
  const double towards = luminanceOf(ground) > middle ? 0.0 : 1.0;
  double low = 0.0;
  double high = 1.0;
  constexpr int steps = 12;
  for (int i = 0; i < steps; ++i) {
    const double share = 0.5 * (low + high);
    (contrastBetween(ground, mixed(colour, towards, share)) >= ratio ? high : low) = share;
  }
  return mixed(colour, towards, high);
}

}  // namespace sline
