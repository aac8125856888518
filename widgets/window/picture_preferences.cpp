// SPDX-License-Identifier: Apache-2.0
#include "widgets/window/picture_preferences.h"

#include <QAction>
#include <array>

#include "widgets/preferences/choice_actions.h"
#include "widgets/viewport/viewport.h"

namespace sline::widgets {

namespace {

struct SwitchAction {
  const char* action;
  const char* preference;
};
constexpr std::array<SwitchAction, 4> switches{{{"showCube", "picture/cube"},
                                                {"showScaleBar", "picture/scaleBar"},
                                                {"showNames", "picture/names"},
                                                {"showFrameTime", "picture/frameTime"}}};

constexpr const char* backgroundKey = "picture/background";

render::Background backgroundOf(const QString& choice) {
  return choice == QLatin1String("dark")    ? render::Background::dark
         : choice == QLatin1String("paper") ? render::Background::paper
                                            : render::Background::white;
}

}  // namespace

PicturePreferences::PicturePreferences(Viewport& viewport, Preferences& preferences,
                                       const WindowActions& actions, QMenu& backgrounds,
                                       QObject* parent)
    : QObject(parent), m_viewport(viewport), m_preferences(preferences), m_actions(actions) {
  for (const SwitchAction& row : switches) {
    QAction& action = m_actions[QLatin1String(row.action)];
    action.setCheckable(true);
    connect(&action, &QAction::triggered, this, [this, preference = row.preference](bool on) {
      m_preferences.set(QLatin1String(preference), on);
    });
  }
  addChoiceActions(backgrounds, preferences, QLatin1String(backgroundKey),
                   QStringLiteral("background"));
  connect(&preferences, &Preferences::changed, this, &PicturePreferences::follow);
  follow();
}

void PicturePreferences::follow() {
  for (const SwitchAction& row : switches)
    m_actions[QLatin1String(row.action)].setChecked(
        m_preferences.isOn(QLatin1String(row.preference)));
  m_viewport.setBackground(backgroundOf(m_preferences.choice(QLatin1String(backgroundKey))));
  const auto on = [this](const char* id) { return m_preferences.isOn(QLatin1String(id)); };
  m_viewport.chooseMarks({.cube = on("picture/cube"),
                          .scaleBar = on("picture/scaleBar"),
                          .frameTime = on("picture/frameTime")});
  m_viewport.setNamesWanted(on("picture/names"));
  m_viewport.setFlights(on("navigation/flights"));
  m_viewport.setMousePreset(
      mousePresetNamed(m_preferences.choice(QStringLiteral("navigation/mouse"))));
}

}  // namespace sline::widgets

#include "moc_picture_preferences.cpp"
