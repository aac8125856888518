// SPDX-License-Identifier: Apache-2.0
// Describes each field of a style once. All code that deals with every field – inheritance, edits,
// blending, scene files, presets, glTF – walks this list, so a new field is two members in
// model/scene/style.h and a row here. Panel and command line name the rows that a person sets.
#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <type_traits>

#include "model/scene/style.h"

namespace sline::model {

/// Describes one field that a style answers. `Own` is the member of `Style`, `Resolved` that of
/// `ResolvedStyle`.
template <auto Own, auto Resolved>
struct StyleField {
  using Value = typename std::remove_cvref_t<decltype(std::declval<Style>().*Own)>::value_type;
  static constexpr auto own = Own;
  static constexpr auto resolved = Resolved;
  /// False for visibility, which is not part of a structure's look: groups above can hide it
  /// whatever its own answer.
  static constexpr bool isLook = !std::same_as<Value, bool>;

  std::string_view key;      ///< its name in scene files, with "_" between words
  Limits<float> plain = {};  ///< limits of a plain number; a `Bounded` has its own

  Limits<float> limits() const {
    if constexpr (std::is_class_v<Value> && requires { Value::clamped(0.0f); })
      return {Value::low, Value::high};
    else
      return plain;
  }
};

namespace style_fields {
inline constexpr StyleField<&Style::colour, &ResolvedStyle::colour> colour{"colour"};
inline constexpr StyleField<&Style::inkColour, &ResolvedStyle::inkColour> inkColour{"ink_colour"};
inline constexpr StyleField<&Style::gamma, &ResolvedStyle::gamma> gamma{"gamma"};
inline constexpr StyleField<&Style::opacity, &ResolvedStyle::opacity> opacity{"opacity"};
inline constexpr StyleField<&Style::fill, &ResolvedStyle::fill> fill{"fill"};
inline constexpr StyleField<&Style::visible, &ResolvedStyle::visible> visible{"visible"};
inline constexpr StyleField<&Style::technique, &ResolvedStyle::technique> technique{"technique"};
inline constexpr StyleField<&Style::lineThresholds, &ResolvedStyle::lineThresholds> lineThresholds{
    "line_thresholds"};
inline constexpr StyleField<&Style::penWeight, &ResolvedStyle::penWeight> penWeight{"pen_weight",
                                                                                    {0, 10}};
inline constexpr StyleField<&Style::lineVariation, &ResolvedStyle::lineVariation> lineVariation{
    "line_variation", {0, 1}};
inline constexpr StyleField<&Style::lineSmoothing, &ResolvedStyle::lineSmoothing> lineSmoothing{
    "line_smoothing", {0, 2}};
inline constexpr StyleField<&Style::shortestLine, &ResolvedStyle::shortestLine> shortestLine{
    "shortest_line", {0, 40}};
inline constexpr StyleField<&Style::lineScale, &ResolvedStyle::lineScale> lineScale{"line_scale",
                                                                                    {0, 2}};
inline constexpr StyleField<&Style::hiddenLines, &ResolvedStyle::hiddenLines> hiddenLines{
    "hidden_lines"};
inline constexpr StyleField<&Style::halo, &ResolvedStyle::halo> halo{"halo", {0, 4}};
inline constexpr StyleField<&Style::grain, &ResolvedStyle::grain> grain{"grain", {0, 1}};
inline constexpr StyleField<&Style::hatchDensity, &ResolvedStyle::hatchDensity> hatchDensity{
    "hatch_density"};
inline constexpr StyleField<&Style::hatchTone, &ResolvedStyle::hatchTone> hatchTone{"hatch_tone"};
inline constexpr StyleField<&Style::gammaMap, &ResolvedStyle::gammaMap> gammaMap{"gamma_by"};
}  // namespace style_fields

/// Calls visit(field) for every field, in the order of scene files.
template <class Visit>
constexpr void forEachStyleField(const Visit& visit) {
  visit(style_fields::colour);
  visit(style_fields::inkColour);
  visit(style_fields::gamma);
  visit(style_fields::opacity);
  visit(style_fields::fill);
  visit(style_fields::visible);
  visit(style_fields::technique);
  visit(style_fields::lineThresholds);
  visit(style_fields::penWeight);
  visit(style_fields::lineVariation);
  visit(style_fields::lineSmoothing);
  visit(style_fields::shortestLine);
  visit(style_fields::lineScale);
  visit(style_fields::hiddenLines);
  visit(style_fields::halo);
  visit(style_fields::grain);
  visit(style_fields::hatchDensity);
  visit(style_fields::hatchTone);
  visit(style_fields::gammaMap);
}

/// Calls visit(field) for the fields that are part of a look: all but the visibility.
template <class Visit>
void forEachLookField(const Visit& visit) {
  forEachStyleField([&visit](const auto& field) {
    if constexpr (std::remove_cvref_t<decltype(field)>::isLook)
      visit(field);
  });
}

/// Takes those answers of a look from `above`, the style of a group further up, that the style
/// lacks.
void inherit(Style& style, const Style& above);
/// Sets the look of the resolved style to the style's answers; fields without an answer stay as
/// they are, except for the ink, which then follows the background.
void answer(ResolvedStyle& resolved, const Style& style);
/// Sets those fields of the style that `patch` answers.
void patch(Style& style, const Style& patch);
/// Clears those fields of the style that `which` answers, whatever the answers are.
void forget(Style& style, const Style& which);
/// Returns those answers of the style whose fields `which` also answers.
Style picked(const Style& style, const Style& which);
/// Returns a style that answers every field of a look, and the visibility, as the resolved style
/// does; an ink that follows the background stays unanswered.
Style answersOf(const ResolvedStyle& resolved);
/// Returns a style that answers every field of a look, for use as `which`.
Style wholeLook();

/// Returns the key in camel case, as JSON of other makers and settings have it: "inkColour".
std::string camelCase(std::string_view key);

}  // namespace sline::model
