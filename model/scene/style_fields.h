// SPDX-License-Identifier: Apache-2.0
// The fields of a style, each described once. Whatever deals with all of them – inheritance, edits,
// blending, scene files, presets, glTF – walks this list, so a new field is two members in
// model/scene/style.h and a row here. Panel and command line name the rows that a person sets.
#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <type_traits>

#include "model/scene/style.h"

namespace sline::model {

/// One question that a style answers. `Own` is the member of `Style`, `Resolved` that of
/// `ResolvedStyle`.
template <auto Own, auto Resolved>
struct StyleField {
  using Value = typename std::remove_cvref_t<decltype(std::declval<Style>().*Own)>::value_type;
  static constexpr auto own = Own;
  static constexpr auto resolved = Resolved;
  /// Whether a structure is shown is no part of its look: groups above hide it whatever it says.
  static constexpr bool isLook = !std::same_as<Value, bool>;

  std::string_view key;      ///< its name in scene files, words parted by "_"
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
inline constexpr StyleField<&Style::penWeight, &ResolvedStyle::penWeight> penWeight{"pen_weight",
                                                                                    {0, 10}};
inline constexpr StyleField<&Style::hatchDensity, &ResolvedStyle::hatchDensity> hatchDensity{
    "hatch_density"};
inline constexpr StyleField<&Style::hatchTone, &ResolvedStyle::hatchTone> hatchTone{"hatch_tone"};
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
  visit(style_fields::penWeight);
  visit(style_fields::hatchDensity);
  visit(style_fields::hatchTone);
}

/// The same for those that are part of a look: all but whether the structure is shown.
template <class Visit>
void forEachLookField(const Visit& visit) {
  forEachStyleField([&visit](const auto& field) {
    if constexpr (std::remove_cvref_t<decltype(field)>::isLook)
      visit(field);
  });
}

/// Takes over what `above`, the style of a group further up, answers of a look and the style does
/// not.
void inherit(Style& style, const Style& above);
/// Answers the look of the resolved style by the style; what that leaves open stays as it is, but
/// for the ink, which then goes with the background.
void answer(ResolvedStyle& resolved, const Style& style);
/// Sets those fields of the style that `patch` answers.
void patch(Style& style, const Style& patch);
/// Clears those fields of the style that `which` answers, whatever it answers.
void forget(Style& style, const Style& which);
/// Returns those answers of the style for whose fields `which` has any.
Style picked(const Style& style, const Style& which);
/// Returns a style that answers every field of a look as the resolved one does, and whether it is
/// shown; an ink that goes with the background stays unanswered.
Style answersOf(const ResolvedStyle& resolved);
/// Returns a style that answers every field of a look, for `which`.
Style wholeLook();

/// Returns the key without "_", as JSON of other makers and settings have it: "inkColour".
std::string camelCase(std::string_view key);

}  // namespace sline::model
