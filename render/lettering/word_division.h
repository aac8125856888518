// SPDX-License-Identifier: Apache-2.0
// Measures words of labels and divides those that are too wide.
#pragma once

#include <QFontMetricsF>
#include <array>
#include <vector>

#include "render/lettering/hyphenation.h"
#include "render/lettering/text_lines.h"

namespace sline::render {

/// Measures advances in the labels' font, in its pixels.
class Ruler {
 public:
  /// Words are divided by the language's syllables, where it has some (BCP 47, empty for none).
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

/// A word, or a part of one that is joined to what stands before it.
struct Word {
  TextLine text;
  bool joined = false;
  bool hyphen = false;  ///< ends in a hyphen if a line ends there
  qreal width = 0.0;    ///< without that hyphen
};

/// Widths in pixels of the font.
struct WordLimits {
  qreal line = 0.0;   ///< wider words are divided
  qreal whole = 0.0;  ///< wider words without a place to divide them are divided anywhere
  qreal part = 0.0;   ///< width of their parts with hyphens; only single signs may be wider
  WordLimits less(qreal by) const { return {line - by, whole - by, part - by}; }
};

/// Divides the word where programs join words ("L4-L3-Disc", "left_kidney", "CystWall") and where
/// the script lets lines end, as between signs of Chinese. Parts that are then wider than
/// `limits.part` are divided between syllables, and parts that are still too wide between signs,
/// into as few parts of about the same width as possible.
std::vector<Word> divided(const Word& word, const Ruler& ruler, const WordLimits& limits);

/// Returns the words between spaces, divided where they are too wide for a line.
std::vector<Word> wordsOf(const TextLine& line, const Ruler& ruler, const WordLimits& limits);

}  // namespace sline::render
