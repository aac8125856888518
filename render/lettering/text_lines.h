// SPDX-License-Identifier: Apache-2.0
// Lines of lettering, made of runs that differ in their letters' style.
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
  float indent = 0.0f;      ///< of all of it, ems
  bool joined = false;      ///< goes on with a word of the line before
  bool hyphenated = false;  ///< ends in a hyphen because the next one does

  TextLine() = default;
  /// Of one run, as labels and marks are.
  TextLine(const QString& plain) : runs{{.text = plain, .style = {}}} {}
  bool operator==(const TextLine&) const = default;
};

/// Adds to the last run where it has that style.
void append(TextLine& line, QStringView text, const model::LetterStyle& style);

/// Its words without styles.
QString plainText(const TextLine& line);
/// Words that lines part are whole.
QString plainText(const std::vector<TextLine>& lines, QChar between = QLatin1Char(' '));

}  // namespace sline::render
