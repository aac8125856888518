// SPDX-License-Identifier: Apache-2.0
// What callouts are written in: a small part of Markdown, nothing of HTML. `**bold**`, `*italic*`,
// one within the other; a line that begins with "- " is an item of a list; after a backslash `*`,
// `-` and `\` are what they look like. A marker begins where a word does and ends where one ends,
// in the same line; one without a partner stays as it was typed.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "model/scene/annotation.h"

namespace sline::model {

struct LetterStyle {
  bool bold = false;
  bool italic = false;
  bool operator==(const LetterStyle&) const = default;
};

/// Bytes of a text that are shown as they stand.
struct MarkupSpan {
  std::size_t begin = 0;
  std::size_t end = 0;
  LetterStyle style;
};

/// Bytes of one line; what no span has are markers and blanks at either end.
struct MarkupLine {
  std::size_t begin = 0;
  std::size_t end = 0;      ///< of the line, without its line break
  std::size_t content = 0;  ///< where its words begin
  bool bullet = false;
  std::vector<MarkupSpan> spans;
};

struct MarkedRun {
  std::string text;
  LetterStyle style;
  bool operator==(const MarkedRun&) const = default;
};

struct MarkedLine {
  bool bullet = false;
  std::vector<MarkedRun> runs;
  bool operator==(const MarkedLine&) const = default;
};

inline constexpr std::string_view bulletSign = "\u2022 ";

constexpr bool isMarkupBlank(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}

/// Of UTF-8, as many lines as the text has. Takes time and memory linear in the text.
std::vector<MarkupLine> parsedMarkup(std::string_view text);
/// What the lines show, neighbouring runs of different styles; without blank lines before the first
/// and after the last that shows something.
std::vector<MarkedLine> markedLines(std::string_view text);

/// What an annotation of that kind shows where styles cannot be: of a callout lines without
/// markers, lists with bullets. Other kinds' texts are plain anyway.
std::string plainText(AnnotationKind kind, const std::string& text);
/// In the language, else the scene's own.
std::string plainTextIn(const Annotation& annotation, const std::string& language);

}  // namespace sline::model
