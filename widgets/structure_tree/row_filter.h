// SPDX-License-Identifier: Apache-2.0
// Finds the rows that match a typed text: words in any order, in any of the names of a structure or
// of the groups above it, whatever the case and the accents; of several such wishes one is enough.
#pragma once

#include <QHash>
#include <QSet>
#include <QStringList>
#include <vector>

#include "model/edit/node_sets.h"
#include "widgets/session/session.h"
#include "widgets/structure_tree/structure_names.h"

namespace sline::widgets {

/// Returns the text as it is compared: without case and accents, '_' and '-' as spaces, "ß" as
/// "ss", "æ" as "ae".
QString searchable(const QString& text);

/// Returns the word that stands between two wishes in the interface's language.
QString orWord();

class RowFilter {
 public:
  void setNames(StructureNames names);
  const StructureNames& names() const { return m_names; }
  /// Sets the text; returns false where it asks for the same as before. Without a word every row
  /// matches. Wishes are parted by "|", a comma, "or" and `orWord`; "left" and "right", in any
  /// language, are found as whole words: "left" does not ask for a cleft.
  bool setText(const QString& text);
  bool active() const { return !m_words.empty(); }

  struct Left {
    model::NodeSet rows;  ///< the matches, all below them and the groups above them
    NodeIds structures;   ///< the matching structures, in tree order
  };
  Left apply(const model::Scene& scene);

 private:
  struct Word {
    QString text;
    bool side = false;
    std::size_t wish = 0;
    bool operator==(const Word&) const = default;
  };
  /// All names of a structure, as they are compared.
  struct Names {
    QString text;
    QSet<QString> words;  ///< of the names that it is shown under
    QStringList sides;    ///< "left" and "right" in other languages, which match as whole words:
                          ///< "rec" asks for the rectum, not for all that is "rechts"
    bool have(const Word& word) const {
      return (word.side ? words.contains(word.text) : text.contains(word.text)) ||
             sides.contains(word.text);
    }
  };
  const Names& namesOf(const std::string& name);
  /// Tells whether all words of a wish are among those that were found.
  bool satisfied(const std::vector<bool>& found) const;

  StructureNames m_names;
  std::vector<Word> m_words;      ///< those of a wish follow each other
  QHash<QString, Names> m_known;  ///< by name
};

}  // namespace sline::widgets
