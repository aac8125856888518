// SPDX-License-Identifier: Apache-2.0
// Which rows a typed text leaves: words in any order, in any of the names of a structure or of the
// groups above it, whatever the case and the accents.
#pragma once

#include <QHash>
#include <QStringList>

#include "model/edit/node_sets.h"
#include "widgets/session/session.h"
#include "widgets/structure_tree/structure_names.h"

namespace sline::widgets {

/// Text as it is compared: case and accents gone, '_' and '-' as spaces, "ß" as "ss", "æ" as "ae".
QString searchable(const QString& text);

class RowFilter {
 public:
  void setNames(StructureNames names);
  const StructureNames& names() const { return m_names; }
  /// False where it asks for the same as before. Without a word everything is left.
  bool setText(const QString& text);
  bool active() const { return !m_words.isEmpty(); }

  struct Left {
    model::NodeSet rows;  ///< what matches, all below it and the groups above it
    NodeIds structures;   ///< those that match, in tree order
  };
  Left apply(const model::Scene& scene);

 private:
  const QString& textOf(const std::string& name);

  StructureNames m_names;
  QStringList m_words;
  QHash<QString, QString> m_texts;  ///< by name: all that it is called, as it is compared
};

}  // namespace sline::widgets
