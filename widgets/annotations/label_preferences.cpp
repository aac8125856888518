// SPDX-License-Identifier: Apache-2.0
#include "widgets/annotations/label_preferences.h"

#include <algorithm>
#include <array>

#include "model/scene/label_words.h"

namespace sline::widgets {

namespace {

constexpr std::array<const char*, 4> modes{"off", "texts", "numbers", "blank"};

}  // namespace

std::string tagOf(std::optional<model::NameLanguage> language) {
  return std::string(language ? model::nameLanguageTags[std::size_t(*language)] : "");
}

render::LabelStyle labelStyle(const Preferences& preferences, const DisplayNames& names) {
  const QString mode = preferences.choice(QLatin1String(labelModeKey));
  const auto found = std::find_if(modes.begin(), modes.end(),
                                  [&mode](const char* id) { return mode == QLatin1String(id); });
  const QString language = preferences.choice(QLatin1String(labelLanguageKey));
  render::LabelStyle style{.mode = render::LabelMode(found - modes.begin()),
                           .points = float(preferences.number(QLatin1String(labelPointsKey))),
                           .language = language.toStdString()};
  if (language == QLatin1String("structures"))
    style.language = tagOf(names.language());
  else if (language == QLatin1String("scene"))
    style.language.clear();
  return style;
}

std::string typedLanguage(const render::LabelStyle& style) {
  return model::firstLanguage(style.language);
}

}  // namespace sline::widgets
