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
  /// All names of a structure, as they are compared.
  struct Names {
    QString text;
    QStringList sides;  ///< "left" and "right" in other languages, which match as whole words:
                        ///< "rec" asks for the rectum, not for all that is "rechts"
    bool have(const QString& word) const { return text.contains(word) || sides.contains(word); }
  };
  const Names& namesOf(const std::string& name);

  StructureNames m_names;
  QStringList m_words;
  QHash<QString, Names> m_known;  ///< by name
};

}  // namespace sline::widgets
