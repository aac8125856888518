// SPDX-License-Identifier: Apache-2.0
#include "widgets/session/display_names.h"

#include <algorithm>
#include <array>

namespace sline::widgets {

void DisplayNames::setLanguage(std::optional<model::NameLanguage> language) {
  if (language == m_language)
    return;
  m_language = language;
  m_shown.clear();
  emit changed();
}

QString DisplayNames::shown(const QString& name) const {
  if (!m_language)
    return name;
  auto found = m_shown.constFind(name);
  if (found == m_shown.constEnd())
    found = m_shown.insert(
        name, QString::fromStdString(m_table.displayName(name.toStdString(), *m_language)));
  return *found;
}

QString DisplayNames::calledIn(const std::string& name, std::string_view tag) const {
  const auto language = model::nameLanguageOf(tag);
  return QString::fromStdString(language ? m_table.displayName(name, *language) : name);
}

QStringList DisplayNames::alsoCalled(const QString& name) const {
  QStringList all;
  for (const std::string& word : m_table.searchWords(name.toStdString()))
    all << QString::fromStdString(word);
  return all;
}

}  // namespace sline::widgets

#include "moc_display_names.cpp"
