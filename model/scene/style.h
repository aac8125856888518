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
#include "model/scene/gamma_map.h"
#include "model/scene/threshold_values.h"

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

/// Says how outlines are drawn where other structures hide them: not at all, thinly, or dashed; in
/// both cases at half strength (METHOD §11.5).
enum class HiddenLines { none, thin, dashed };
inline constexpr std::array<std::string_view, 3> hiddenLinesNames{"none", "thin", "dashed"};
inline std::span<const std::string_view> namesOf(HiddenLines /*any*/) {
  return hiddenLinesNames;
}

/// Says which technique draws the lines within a structure's contours: the one that Γ leads from
/// suggestive contours to hatching (S), or one of those that it is compared with. ConFIS (C) draws
/// short streamlines along contours and where the curvature has an extremum; streamline hatching
/// and noise LIC follow the same directions and tell light and shade.
enum class Technique {
  sline,
  confis,
  apparentRidges,
  ridges,
  photic,
  laplacian,
  demarcating,
  highlights,
  streamlineHatching,
  noiseLic
};
inline constexpr std::array<std::string_view, 10> techniqueNames{
    "sline",       "confis",     "apparent_ridges",     "ridges",   "photic", "laplacian",
    "demarcating", "highlights", "streamline_hatching", "noise_lic"};
inline std::span<const std::string_view> namesOf(Technique /*any*/) {
  return techniqueNames;
}

struct Style {
  std::optional<Colour> colour;
  std::optional<Colour> inkColour;
  std::optional<Gamma> gamma;
  std::optional<Opacity> opacity;
  std::optional<Fill> fill;
  std::optional<bool> visible;
  std::optional<Technique> technique;
  std::optional<ThresholdValues> lineThresholds;
  std::optional<float> penWeight;
  std::optional<float> lineVariation;
  std::optional<float> lineSmoothing;
  std::optional<float> shortestLine;
  std::optional<float> lineScale;
  std::optional<HiddenLines> hiddenLines;
  std::optional<float> halo;
  std::optional<float> grain;
  std::optional<HatchDensity> hatchDensity;
  std::optional<HatchTone> hatchTone;
  std::optional<GammaMap> gammaMap;
  bool operator==(const Style&) const = default;
};

/// A resolved style answers every field.
struct ResolvedStyle {
  Colour colour{200, 200, 200};
  std::optional<Colour> inkColour;  ///< absent: black, or white on a dark background
  Gamma gamma = Gamma::clamped(2.0f);
  Opacity opacity = Opacity::clamped(1.0f);
  Fill fill = Fill::none;
  bool visible = true;  ///< also false where a group above is hidden
  Technique technique = Technique::sline;
  ThresholdValues lineThresholds;  ///< of any technique, where they are not the usual ones
  float penWeight = 1.0f;          ///< factor on the scene's pen of 2 λ (METHOD §4)
  /// How much the pen's pressure tells form, 0 … 1 (METHOD §11.4); 0: an even pen.
  float lineVariation = 1.0f;
  float lineSmoothing =
      1.0f;  ///< times 3 λ, within which lines turn back and forth no more (§11.2)
  float shortestLine = 8.0f;  ///< λ; shorter pieces are crumbs that no pen draws (§11.3)
  float lineScale = 1.0f;  ///< times 4 λ, the scale of suggestive contours and hatching (§11.8)
  HiddenLines hiddenLines = HiddenLines::none;
  float halo = 0.0f;   ///< pens; lines behind stop this far from its outline (METHOD §11.6)
  float grain = 0.0f;  ///< how much of the pen is a pencil on rough paper, 0 … 1
  HatchDensity hatchDensity = HatchDensity::clamped(1.0f);
  HatchTone hatchTone = HatchTone::clamped(1.0f);
  GammaMap gammaMap;  ///< how Γ varies over the surface
  bool operator==(const ResolvedStyle&) const = default;
};

}  // namespace sline::model
