// SPDX-License-Identifier: Apache-2.0
// Finds the rows that match a typed text: words in any order, in any of the names of a structure or
// of the groups above it, whatever the case and the accents.
#pragma once

#include <QHash>
#include <QStringList>

#include "model/edit/node_sets.h"
#include "widgets/session/session.h"
#include "widgets/structure_tree/structure_names.h"

namespace sline::widgets {

/// Returns the text as it is compared: without case and accents, '_' and '-' as spaces, "ß" as
/// "ss", "æ" as "ae".
QString searchable(const QString& text);

class RowFilter {
 public:
  void setNames(StructureNames names);
  const StructureNames& names() const { return m_names; }
  /// Sets the text; returns false where it asks for the same as before. Without a word every row
  /// matches.
  bool setText(const QString& text);
  bool active() const { return !m_words.isEmpty(); }

  struct Left {
    model::NodeSet rows;  ///< the matches, all below them and the groups above them
    NodeIds structures;   ///< the matching structures, in tree order
  };
  Left apply(const model::Scene& scene);

 private:
  const QString& textOf(const std::string& name);

  StructureNames m_names;
  QStringList m_words;
  QHash<QString, QString> m_texts;  ///< by name: all names of the structure, as they are compared
};

}  // namespace sline::widgets
