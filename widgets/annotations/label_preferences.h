// SPDX-License-Identifier: Apache-2.0
// Turns the preferences into the look of labels in the window.
#pragma once

#include <string>

#include "render/lettering/label_style.h"
#include "widgets/preferences/preferences.h"
#include "widgets/session/display_names.h"

namespace sline::widgets {

inline constexpr const char* labelModeKey = "labels/mode";
inline constexpr const char* labelLanguageKey = "labels/language";
inline constexpr const char* labelPointsKey = "labels/points";

/// Returns the tag of a language of names; the scene's own where there is none.
std::string tagOf(std::optional<model::NameLanguage> language);

/// Returns the look that the preferences give; where labels follow the structures, `names` gives
/// the language.
render::LabelStyle labelStyle(const Preferences& preferences, const DisplayNames& names);
/// Returns the language in which labels are typed: the first of those that they are shown in.
std::string typedLanguage(const render::LabelStyle& style);

}  // namespace sline::widgets
