// SPDX-License-Identifier: Apache-2.0
// Understands what is typed to find something by its names: words in any order, whatever the case
// and the accents; of several such wishes one is enough.
#pragma once

#include <QSet>
#include <QString>
#include <QStringList>
#include <vector>

namespace sline::widgets {

/// Returns the text as it is compared: without case and accents, '_' and '-' as spaces, "ß" as
/// "ss", "æ" as "ae".
QString searchable(const QString& text);

/// Returns the word that stands between two wishes in the interface's language.
QString orWord();

/// A word that was typed.
struct WishedWord {
  QString text;
  bool side = false;
  std::size_t wish = 0;
  bool operator==(const WishedWord&) const = default;
};

/// Holds all names of something, as they are compared.
struct SearchedNames {
  QString text;
  QSet<QString> words;  ///< of the names that it is shown under
  QStringList sides;    ///< "left" and "right" in other languages, which match as whole words:
                        ///< "rec" asks for the rectum, not for all that is "rechts"
  /// Adds the words of a name that is shown, also where capitals alone part them.
  void addWords(const QString& name);
  bool have(const WishedWord& word) const {
    return (word.side ? words.contains(word.text) : text.contains(word.text)) ||
           sides.contains(word.text);
  }
};

class TypedWishes {
 public:
  /// Sets the text; returns false where it asks for the same as before. Without a word everything
  /// matches. Wishes are parted by "|", a comma, "or" and `orWord`; "left" and "right", in any
  /// language, are found as whole words: "left" does not ask for a cleft.
  bool setText(const QString& text);
  bool active() const { return !m_words.empty(); }
  /// Those of a wish follow each other.
  const std::vector<WishedWord>& words() const { return m_words; }
  /// Tells whether all words of a wish are among those that were found.
  bool satisfied(const std::vector<bool>& found) const;

 private:
  std::vector<WishedWord> m_words;
};

}  // namespace sline::widgets
