// SPDX-License-Identifier: Apache-2.0
#include "widgets/preferences/preferences.h"

#include <QSettings>
#include <algorithm>

namespace sline::widgets {

namespace {

PreferenceRow rowOf(const QString& id) {
  const std::vector<PreferenceRow> rows = preferenceRows();
  const auto found = std::find_if(rows.begin(), rows.end(),
                                  [&id](const PreferenceRow& row) { return row.field.id == id; });
  Q_ASSERT(found != rows.end());
  return *found;
}

}  // namespace

Field preferenceField(const QString& id) {
  return rowOf(id).field;
}

Preferences::Preferences(QSettings& settings, QObject* parent)
    : QObject(parent), m_settings(settings) {}

QVariant Preferences::value(const QString& id) const {
  const PreferenceRow row = rowOf(id);
  const QVariant set = m_settings.value(id);
  return allows(row.field.kind, set) ? set : row.standard;
}

bool Preferences::isOn(const QString& id) const {
  Q_ASSERT(std::holds_alternative<SwitchField>(rowOf(id).field.kind));
  return value(id).toBool();
}

QString Preferences::choice(const QString& id) const {
  Q_ASSERT(std::holds_alternative<ChoiceField>(rowOf(id).field.kind));
  return value(id).toString();
}

int Preferences::number(const QString& id) const {
  Q_ASSERT(std::holds_alternative<NumberField>(rowOf(id).field.kind));
  return value(id).toInt();
}

bool Preferences::set(const QString& id, const QVariant& given) {
  const PreferenceRow row = rowOf(id);
  if (!allows(row.field.kind, given) || value(id).toString() == given.toString())
    return false;
  m_settings.setValue(id, given);
  emit changed(id);
  return true;
}

void Preferences::restoreStandards() {
  for (const PreferenceRow& row : preferenceRows())
    set(row.field.id, row.standard);
}

}  // namespace sline::widgets

#include "moc_preferences.cpp"
