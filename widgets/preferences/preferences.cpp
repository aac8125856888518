// SPDX-License-Identifier: Apache-2.0
#include "widgets/preferences/preferences.h"

#include <QSettings>
#include <algorithm>

namespace sline::widgets {

namespace {

PreferenceRow rowOf(const QString& id) {
  const std::vector<PreferenceRow> rows = preferenceRows();
  const auto found = std::find_if(rows.begin(), rows.end(),
                                  [&id](const PreferenceRow& row) { return row.id == id; });
  Q_ASSERT(found != rows.end());
  return *found;
}

QVariant standardOf(const PreferenceRow& row) {
  return std::visit([](const auto& kind) { return QVariant(kind.standard); }, row.kind);
}

bool allowed(const QVariant& value, const ChoiceOf& choice) {
  return std::any_of(choice.rows.begin(), choice.rows.end(),
                     [&value](const ChoiceOf::Row& row) { return row.id == value.toString(); });
}

bool allowed(const QVariant& value, const WholeNumber& number) {
  bool whole = false;
  const int i = value.toInt(&whole);
  return whole && i >= number.low && i <= number.high;
}

/// Settings files hold "true" and "false" as words.
bool allowed(const QVariant& value, const Switch&) {
  return value.typeId() == QMetaType::Bool || value.toString() == QLatin1String("true") ||
         value.toString() == QLatin1String("false");
}

}  // namespace

Preferences::Preferences(QSettings& settings, QObject* parent)
    : QObject(parent), m_settings(settings) {}

QVariant Preferences::value(const QString& id) const {
  const PreferenceRow row = rowOf(id);
  const QVariant set = m_settings.value(id);
  const bool good = set.isValid() &&
                    std::visit([&set](const auto& kind) { return allowed(set, kind); }, row.kind);
  return good ? set : standardOf(row);
}

bool Preferences::isOn(const QString& id) const {
  Q_ASSERT(std::holds_alternative<Switch>(rowOf(id).kind));
  return value(id).toBool();
}

QString Preferences::choice(const QString& id) const {
  Q_ASSERT(std::holds_alternative<ChoiceOf>(rowOf(id).kind));
  return value(id).toString();
}

int Preferences::number(const QString& id) const {
  Q_ASSERT(std::holds_alternative<WholeNumber>(rowOf(id).kind));
  return value(id).toInt();
}

bool Preferences::set(const QString& id, const QVariant& given) {
  const PreferenceRow row = rowOf(id);
  const bool good =
      std::visit([&given](const auto& kind) { return allowed(given, kind); }, row.kind);
  if (!good || value(id).toString() == given.toString())
    return false;
  m_settings.setValue(id, given);
  emit changed(id);
  return true;
}

void Preferences::restoreStandards() {
  for (const PreferenceRow& row : preferenceRows())
    set(row.id, standardOf(row));
}

}  // namespace sline::widgets

#include "moc_preferences.cpp"
