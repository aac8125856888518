// SPDX-License-Identifier: Apache-2.0
#include "widgets/session/shown_names.h"

namespace sline::widgets {

void ShownNames::setLanguage(std::optional<model::NameLanguage> language) {
  if (language == m_language)
    return;
  m_language = language;
  m_shown.clear();
  emit changed();
}

QString ShownNames::shown(const QString& name) const {
  if (!m_language)
    return name;
  auto found = m_shown.constFind(name);
  if (found == m_shown.constEnd())
    found = m_shown.insert(
        name, QString::fromStdString(m_table.displayName(name.toStdString(), *m_language)));
  return *found;
}

QStringList ShownNames::alsoCalled(const QString& name) const {
  QStringList all;
  for (const std::string& word : m_table.searchWords(name.toStdString()))
    all << QString::fromStdString(word);
  return all;
}

}  // namespace sline::widgets
