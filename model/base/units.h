// SPDX-License-Identifier: Apache-2.0
// Strong value types: a number that knows what it is and that it is in range.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <cstdint>
#include <optional>

namespace sline {

/// The lowest and highest value that something takes.
template <class Number>
struct Limits {
  Number low{};
  Number high{};
  bool operator==(const Limits&) const = default;
  constexpr bool contain(Number value) const { return value >= low && value <= high; }
};

/// A float held in [Low, High]; `from` refuses what lies outside, `clamped` pulls it in.
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

/// The one style parameter Γ ∈ [0, 5]: silhouette, contours, suggestive contours, hatching, Phong.
using Gamma = Bounded<struct GammaTag, 0, 5>;
/// 0 see-through … 1 opaque.
using Opacity = Bounded<struct OpacityTag, 0, 1>;
/// How many strokes hatching has, times the usual; their tone together stays the same. 0: none.
using HatchDensity = Bounded<struct HatchDensityTag, 0, 4>;
/// How dark hatching is, times the usual. 0: blank.
using HatchTone = Bounded<struct HatchToneTag, 0, 4>;

/// An sRGB colour, 8 bits a channel, without alpha.
struct Colour {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;
  auto operator<=>(const Colour&) const = default;
};

}  // namespace sline
