// SPDX-License-Identifier: Apache-2.0
// Defines strong value types: numbers that know what they mean and that they are in range.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <cstdint>
#include <optional>

namespace sline {

/// Holds the lowest and the highest value that something can take.
template <class Number>
struct Limits {
  Number low{};
  Number high{};
  bool operator==(const Limits&) const = default;
  constexpr bool contain(Number value) const { return value >= low && value <= high; }
};

/// Holds a float in [Low, High]; `from` refuses a value outside, `clamped` pulls it in.
template <class Tag, int Low, int High>
class Bounded {
 public:
  static constexpr float low = float(Low);
  static constexpr float high = float(High);
  constexpr Bounded() = default;
  static std::optional<Bounded> from(float value) {
    if (!(value >= float(Low) && value <= float(High)))
      return std::nullopt;
    return Bounded(value);
  }
  static Bounded clamped(float value) {
    return Bounded(std::isnan(value) ? float(Low) : std::clamp(value, float(Low), float(High)));
  }
  constexpr float value() const { return m_value; }
  auto operator<=>(const Bounded&) const = default;

 private:
  explicit constexpr Bounded(float value) : m_value(value) {}
  float m_value = float(Low);
};

/// Γ ∈ [0, 5] is the one style parameter: silhouette, contours, suggestive contours, hatching,
/// Phong.
using Gamma = Bounded<struct GammaTag, 0, 5>;
/// Opacity runs from 0 (see-through) to 1 (opaque).
using Opacity = Bounded<struct OpacityTag, 0, 1>;
/// Multiplies the usual number of hatching strokes; their overall tone stays the same. 0 means
/// none.
using HatchDensity = Bounded<struct HatchDensityTag, 0, 4>;
/// Multiplies the usual darkness of hatching; 0 leaves it blank.
using HatchTone = Bounded<struct HatchToneTag, 0, 4>;

/// Holds an sRGB colour with 8 bits per channel and no alpha.
struct Colour {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;
  auto operator<=>(const Colour&) const = default;
};

}  // namespace sline
