// SPDX-License-Identifier: Apache-2.0
// Finds where syllables end, by the patterns that the system's dictionaries hold for a language
// (libhyphen, after F. M. Liang, "Word Hy-phen-a-tion by Com-put-er", Stanford 1983).
#pragma once

#include <QString>
#include <memory>
#include <vector>

namespace sline::render {

class SyllablePatterns;

/// Holds the patterns of one language, which are loaded once for each language that is asked for.
class Hyphenation {
 public:
  /// Loads the patterns of a BCP 47 language ("de", "nb", "en-GB"), the region's own where they are
  /// installed. Without a language, for one that has none (Latin) or where no dictionary is
  /// installed, it knows no syllables. May be called from any thread.
  explicit Hyphenation(const std::string& language = {});

  /// Returns the places in the text, counted in QChars, where a syllable of one of its words ends
  /// and another follows: each leaves two letters before it and three behind it in the word. Words
  /// of more than 60 letters have none.
  std::vector<qsizetype> syllableEnds(const QString& text) const;

 private:
  std::shared_ptr<const SyllablePatterns> m_patterns;
};

}  // namespace sline::render
