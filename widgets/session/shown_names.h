// SPDX-License-Identifier: Apache-2.0
// What structures are called on screen. The scene keeps the names of its file.
#pragma once

#include <QHash>
#include <QObject>
#include <QString>
#include <QStringList>
#include <optional>

#include "model/anatomy/anatomical_names.h"

namespace sline::widgets {

class ShownNames : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  /// Nothing: as in the file.
  std::optional<model::NameLanguage> language() const { return m_language; }
  void setLanguage(std::optional<model::NameLanguage> language);

  /// The name as people read it; plain text.
  QString shown(const QString& name) const;
  QString shown(const std::string& name) const { return shown(QString::fromStdString(name)); }
  /// True where the table has the name, in every language.
  bool knows(const std::string& name) const { return m_table.knows(name); }
  /// In the language of that tag ("la"); of an empty or unknown one the name itself.
  QString calledIn(const std::string& name, std::string_view tag) const;
  /// All that the structure is called in any language.
  QStringList alsoCalled(const QString& name) const;

 signals:
  /// Whoever shows names shows them anew.
  void changed();

 private:
  model::AnatomicalNames m_table;
  std::optional<model::NameLanguage> m_language;
  /// Looked up once for each name: a body has thousands, and each is painted often.
  mutable QHash<QString, QString> m_shown;
};

}  // namespace sline::widgets
