// SPDX-License-Identifier: Apache-2.0
// Translates the names of structures for the screen. The scene keeps the names of its file.
#pragma once

#include <QHash>
#include <QObject>
#include <QString>
#include <QStringList>
#include <optional>

#include "model/anatomy/anatomical_names.h"

namespace sline::widgets {

class DisplayNames : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  /// Returns the language of names; none for names as in the file.
  std::optional<model::NameLanguage> language() const { return m_language; }
  void setLanguage(std::optional<model::NameLanguage> language);

  /// Returns the name as the user reads it; plain text.
  QString shown(const QString& name) const;
  QString shown(const std::string& name) const { return shown(QString::fromStdString(name)); }
  /// Tells whether the table has the name, in every language.
  bool knows(const std::string& name) const { return m_table.knows(name); }
  /// Returns the name in the language of that tag ("la"); for an empty or unknown one the name
  /// itself.
  QString calledIn(const std::string& name, std::string_view tag) const;
  /// Returns all names of the structure in any language.
  QStringList alsoCalled(const QString& name) const;

 signals:
  /// Tells that shown names must be refreshed.
  void changed();

 private:
  model::AnatomicalNames m_table;
  std::optional<model::NameLanguage> m_language;
  /// Caches each name after its first look-up: a body has thousands, and each is painted often.
  mutable QHash<QString, QString> m_shown;
};

}  // namespace sline::widgets
