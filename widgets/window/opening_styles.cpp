// SPDX-License-Identifier: Apache-2.0
#include "widgets/window/opening_styles.h"

#include "widgets/gamma/drawing_panel.h"
#include "widgets/start/drawing_choice.h"

namespace sline::widgets {

namespace {

constexpr const char* openingLookKey = "picture/openingLook";
constexpr const char* openingGroundKey = "picture/background";

QString textOf(std::string_view id) {
  return QString::fromUtf8(id.data(), qsizetype(id.size()));
}

QString groundOf(const model::DrawingStyle& style) {
  return textOf(style.background);
}

/// Returns the value that the preference has for a style; that of the plate is older than styles.
QString preferenceOf(const model::DrawingStyle& style) {
  return style.styleOf ? textOf(style.id) : QStringLiteral("auto");
}

}  // namespace

void prepareBackground(Preferences& preferences, const model::DrawingStyle& style) {
  if (style.styleOf)
    preferences.set(QLatin1String(openingGroundKey), groundOf(style));
}

const model::DrawingStyle* openingStyle(const Preferences& preferences) {
  const QString chosen = preferences.choice(QLatin1String(openingLookKey));
  for (const model::DrawingStyle& style : model::drawingStyles())
    if (preferenceOf(style) == chosen)
      return &style;
  return nullptr;
}

void offerOpeningStyles(DrawingChoice& choice, Preferences& preferences) {
  std::vector<OfferedDrawing> offered;
  const std::vector<DrawingText> texts = drawingTexts();
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const model::DrawingStyle& style = model::drawingStyles()[i];
    offered.push_back({.id = preferenceOf(style),
                       .picture = QStringLiteral("drawing-") + textOf(style.id),
                       .name = texts[i].name,
                       .description = texts[i].description});
  }
  choice.offer(offered);
  const auto follow = [&choice, &preferences] {
    choice.setChosen(preferences.choice(QLatin1String(openingLookKey)));
  };
  QObject::connect(&choice, &DrawingChoice::chosen, &preferences,
                   [&preferences](const QString& id) {
                     const model::DrawingStyle* before = openingStyle(preferences);
                     preferences.set(QLatin1String(openingLookKey), id);
                     const model::DrawingStyle* now = openingStyle(preferences);
                     // A plate goes with any background, but not with one that came with another
                     // style.
                     if (before && before->styleOf && now && !now->styleOf &&
                         preferences.choice(QLatin1String(openingGroundKey)) == groundOf(*before))
                       preferences.set(QLatin1String(openingGroundKey), groundOf(*now));
                   });
  QObject::connect(&preferences, &Preferences::changed, &choice, follow);
  follow();
}

}  // namespace sline::widgets
