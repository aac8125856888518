// SPDX-License-Identifier: Apache-2.0
#include "widgets/preferences/choice_actions.h"

#include <QActionGroup>
#include <QMenu>

#include "widgets/preferences/preferences.h"

namespace sline::widgets {

void addChoiceActions(QMenu& menu, Preferences& preferences, const QString& id,
                      const QString& names) {
  auto* group = new QActionGroup(&menu);
  const Field field = preferenceField(id);
  for (const Choice& choice : std::get<ChoiceField>(field.kind).choices) {
    QAction* action = menu.addAction(choice.text);
    action->setObjectName(names + QLatin1Char('-') + choice.id);
    action->setCheckable(true);
    action->setData(choice.id);
    group->addAction(action);
    QObject::connect(action, &QAction::triggered, &preferences,
                     [&preferences, id, chosen = choice.id] { preferences.set(id, chosen); });
  }
  const auto show = [&preferences, id, group] {
    for (QAction* action : group->actions())
      action->setChecked(action->data().toString() == preferences.choice(id));
  };
  QObject::connect(&preferences, &Preferences::changed, group, show);
  show();
}

}  // namespace sline::widgets
