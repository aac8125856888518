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
  float indent = 0.0f;  ///< of all of it, ems

  TextLine() = default;
  /// Of one run, as labels and marks are.
  TextLine(const QString& plain) : runs{{.text = plain, .style = {}}} {}
  bool operator==(const TextLine&) const = default;
};

/// Adds to the last run where it has that style.
void append(TextLine& line, QStringView text, const model::LetterStyle& style);

/// Its words without styles.
QString plainText(const TextLine& line);
QString plainText(const std::vector<TextLine>& lines, QChar between = QLatin1Char(' '));

}  // namespace sline::render
