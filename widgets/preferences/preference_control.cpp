// SPDX-License-Identifier: Apache-2.0
#include "widgets/preferences/preference_control.h"

#include <QWidget>

namespace sline::widgets {

QWidget* makePreferenceControl(Preferences& preferences, const QString& id) {
  const Field field = preferenceField(id);
  QWidget* control =
      makeControl(field, [&preferences, id](const QVariant& value) { preferences.set(id, value); });
  control->setAccessibleName(field.text);
  const auto show = [&preferences, control, field] {
    showValue(*control, field.kind, preferences.value(field.id));
  };
  QObject::connect(&preferences, &Preferences::changed, control, show);
  show();
  return control;
}

}  // namespace sline::widgets
