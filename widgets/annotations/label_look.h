// SPDX-License-Identifier: Apache-2.0
// How a person wants labels in the window: what the preferences say of it.
#pragma once

#include <QString>
#include <vector>

#include "render/lettering/label_style.h"
#include "widgets/preferences/preferences.h"
#include "widgets/session/shown_names.h"

namespace sline::widgets {

inline constexpr const char* labelModeKey = "labels/mode";
inline constexpr const char* labelLanguageKey = "labels/language";
inline constexpr const char* labelPointsKey = "labels/points";

/// A language that labels can be written in.
struct LabelLanguage {
  std::string tag;  ///< BCP 47; empty: the scene's own
  QString name;
};
/// The scene's own first.
std::vector<LabelLanguage> labelLanguages();
/// The tag of a language of names; of none the scene's own.
std::string tagOf(std::optional<model::NameLanguage> language);

/// As the preferences say; where labels follow the structures, `names` says which language that is.
render::LabelStyle labelStyle(const Preferences& preferences, const ShownNames& names);

}  // namespace sline::widgets
