// SPDX-License-Identifier: Apache-2.0
// Turns the preferences into the look of labels in the window.
#pragma once

#include <QString>
#include <vector>

#include "render/lettering/label_style.h"
#include "widgets/preferences/preferences.h"
#include "widgets/session/display_names.h"

namespace sline::widgets {

inline constexpr const char* labelModeKey = "labels/mode";
inline constexpr const char* labelLanguageKey = "labels/language";
inline constexpr const char* labelPointsKey = "labels/points";

/// A language that labels can be written in.
struct LabelLanguage {
  std::string tag;  ///< BCP 47; empty for the scene's own
  QString name;
};
/// Returns the languages that labels can be written in, the scene's own first.
std::vector<LabelLanguage> labelLanguages();
/// Returns the tag of a language of names; the scene's own where there is none.
std::string tagOf(std::optional<model::NameLanguage> language);

/// Returns the look that the preferences give; where labels follow the structures, `names` gives
/// the language.
render::LabelStyle labelStyle(const Preferences& preferences, const DisplayNames& names);

}  // namespace sline::widgets
