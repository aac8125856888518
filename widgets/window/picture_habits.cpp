// SPDX-License-Identifier: Apache-2.0
#include "widgets/window/picture_habits.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <algorithm>
#include <array>

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

PictureHabits::PictureHabits(Viewport& viewport, Preferences& preferences,
                             const WindowActions& actions, QMenu& backgrounds, QObject* parent)
    : QObject(parent), m_viewport(viewport), m_preferences(preferences), m_actions(actions) {
  for (const SwitchAction& row : switches) {
    QAction& action = m_actions[QLatin1String(row.action)];
    action.setCheckable(true);
    connect(&action, &QAction::triggered, this, [this, preference = row.preference](bool on) {
      m_preferences.set(QLatin1String(preference), on);
    });
  }
  fill(backgrounds);
  connect(&preferences, &Preferences::changed, this, &PictureHabits::follow);
  follow();
}

void PictureHabits::fill(QMenu& backgrounds) {
  const QString id = QLatin1String(backgroundKey);
  const std::vector<PreferenceRow> rows = preferenceRows();
  const auto row = std::find_if(rows.begin(), rows.end(),
                                [&id](const PreferenceRow& each) { return each.id == id; });
  auto* group = new QActionGroup(this);
  for (const ChoiceOf::Row& choice : std::get<ChoiceOf>(row->kind).rows) {
    QAction* action = backgrounds.addAction(choice.text);
    action->setObjectName(QStringLiteral("background-") + choice.id);
    action->setCheckable(true);
    group->addAction(action);
    connect(action, &QAction::triggered, this,
            [this, id, chosen = choice.id] { m_preferences.set(id, chosen); });
  }
  const auto follow = [this, id, group] {
    const QString chosen = m_preferences.choice(id);
    for (QAction* action : group->actions())
      action->setChecked(action->objectName() == QStringLiteral("background-") + chosen);
    m_viewport.setBackground(backgroundOf(chosen));
  };
  connect(&m_preferences, &Preferences::changed, group, follow);
  follow();
}

void PictureHabits::follow() {
  for (const SwitchAction& row : switches)
    m_actions[QLatin1String(row.action)].setChecked(
        m_preferences.isOn(QLatin1String(row.preference)));
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

#include "moc_picture_habits.cpp"
