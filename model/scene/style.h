// SPDX-License-Identifier: Apache-2.0
// Defines how a structure is drawn. A `Style` holds only the answers of its own node; the fields it
// leaves open come from the group above (`Scene::resolve`), and at the top from the defaults of
// `ResolvedStyle`. Each field has a row in model/scene/style_fields.h.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "model/base/units.h"

namespace sline::model {

/// Says how an unfilled structure treats the things behind it: leaves them, hides them (in the
/// background's colour), covers them with a flat thin wash of its own colour (METHOD §7, interior),
/// or lets them show faintly, as through tracing paper.
enum class Fill { none, paper, tint, veil };
inline constexpr std::array<std::string_view, 4> fillNames{"none", "paper", "tint", "veil"};
/// Returns the names of the values in files and on the command line, in their order.
inline std::span<const std::string_view> namesOf(Fill /*any*/) {
  return fillNames;
}

struct Style {
  std::optional<Colour> colour;
  std::optional<Colour> inkColour;
  std::optional<Gamma> gamma;
  std::optional<Opacity> opacity;
  std::optional<Fill> fill;
  std::optional<bool> visible;
  std::optional<float> penWeight;
  std::optional<HatchDensity> hatchDensity;
  std::optional<HatchTone> hatchTone;
  bool operator==(const Style&) const = default;
};

/// A resolved style answers every field.
struct ResolvedStyle {
  Colour colour{200, 200, 200};
  std::optional<Colour> inkColour;  ///< absent: black, or white on a dark background
  Gamma gamma = Gamma::clamped(2.0f);
  Opacity opacity = Opacity::clamped(1.0f);
  Fill fill = Fill::none;
  bool visible = true;     ///< also false where a group above is hidden
  float penWeight = 1.0f;  ///< factor on the scene's pen of 2 λ (METHOD §4)
  HatchDensity hatchDensity = HatchDensity::clamped(1.0f);
  HatchTone hatchTone = HatchTone::clamped(1.0f);
  bool operator==(const ResolvedStyle&) const = default;
};

}  // namespace sline::model
