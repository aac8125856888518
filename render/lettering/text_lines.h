// SPDX-License-Identifier: Apache-2.0
// Holds lines of lettering, made of runs that differ in their letters' style.
#pragma once

#include <QString>
#include <vector>

#include "model/scene/markup.h"

namespace sline::render {

struct TextRun {
  QString text;  ///< plain
  model::LetterStyle style;
  bool operator==(const TextRun&) const = default;
};

struct TextLine {
  std::vector<TextRun> runs;
  float indent = 0.0f;      ///< of the whole line, ems
  bool joined = false;      ///< continues a word of the line before
  bool hyphenated = false;  ///< ends in a hyphen because the next line continues its word

  TextLine() = default;
  /// Makes a line of one run, as labels and marks have it.
  TextLine(const QString& plain) : runs{{.text = plain, .style = {}}} {}
  bool operator==(const TextLine&) const = default;
};

/// Appends the text to the last run if that has this style, or else as a new run.
void append(TextLine& line, QStringView text, const model::LetterStyle& style);

/// Returns the line's words without styles.
QString plainText(const TextLine& line);
/// Returns the text of all lines; words that lines divide are whole.
QString plainText(const std::vector<TextLine>& lines, QChar between = QLatin1Char(' '));

}  // namespace sline::render
