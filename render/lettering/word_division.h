// SPDX-License-Identifier: Apache-2.0
// Words of labels and how wide they are; where one may be parted that is too wide.
#pragma once

#include <QFontMetricsF>
#include <array>
#include <vector>

#include "render/lettering/hyphenation.h"
#include "render/lettering/text_lines.h"

namespace sline::render {

/// Advances in the labels' font, in its pixels.
class Ruler {
 public:
  /// Words are parted by the language's syllables where it has some (BCP 47, empty for none).
  explicit Ruler(const std::string& language = {});
  qreal width(const TextRun& run) const;
  qreal width(const TextLine& line) const;
  qreal hyphen() const { return m_hyphen; }
  const Hyphenation& hyphenation() const { return m_hyphenation; }

 private:
  std::array<QFontMetricsF, 4> m_metrics;
  qreal m_hyphen = 0.0;
  Hyphenation m_hyphenation;
};

/// A word, or a part of one: joined to what stands before it.
struct Word {
  TextLine text;
  bool joined = false;
  bool hyphen = false;  ///< has one behind it where a line ends there
  qreal width = 0.0;    ///< without that
};

/// Pixels of the font.
struct WordLimits {
  qreal line = 0.0;   ///< what is wider is divided
  qreal whole = 0.0;  ///< what is wider and has no place for it is divided anywhere
  qreal part = 0.0;   ///< what it is then divided into, but for single signs, with their hyphens
  WordLimits less(qreal by) const { return {line - by, whole - by, part - by}; }
};

/// Divided where programs join words ("L4-L3-Disc", "left_kidney", "CystWall") and where the script
/// lets lines end, as between signs of Chinese. What is then wider than `limits.part` is divided
/// between syllables, and what is still too wide between signs, into as few parts of about the same
/// width as can be.
std::vector<Word> divided(const Word& word, const Ruler& ruler, const WordLimits& limits);

/// What spaces part, divided where it is too wide for a line.
std::vector<Word> wordsOf(const TextLine& line, const Ruler& ruler, const WordLimits& limits);

}  // namespace sline::render
