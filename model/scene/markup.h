// SPDX-License-Identifier: Apache-2.0
// Parses the language of callouts: a small part of Markdown, without any HTML. It has `**bold**`
// and `*italic*`, also nested; a line that begins with "- " is an item of a list; after a backslash
// `*`, `-`, `[` and `\` are shown as they are. A marker begins where a word does and ends where one
// ends, in the same line; one without a partner stays as it was typed. "[ureter](#structure=left
// ureter)" and "[from behind](#view=2)" are links, of which the words are shown; other brackets
// stay as they were typed.
#pragma once

#include <cstddef>
#include <optional>
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

/// Says where words lead: to a structure or a view (`linkTarget` finds which).
struct MarkupLink {
  enum class To { structure, view };
  To to = To::structure;
  std::string name;
  bool operator==(const MarkupLink&) const = default;
};

/// Marks bytes of a text that are shown as they are.
struct MarkupSpan {
  std::size_t begin = 0;
  std::size_t end = 0;
  LetterStyle style;
  std::optional<std::size_t> link;  ///< its place among the line's links
};

/// Marks the bytes of one line; those in no span are markers and blanks at either end.
struct MarkupLine {
  std::size_t begin = 0;
  std::size_t end = 0;      ///< end of the line, without its line break
  std::size_t content = 0;  ///< where its words begin
  bool bullet = false;
  std::vector<MarkupSpan> spans;
  std::vector<MarkupLink> links;
};

struct MarkedRun {
  std::string text;
  LetterStyle style;
  std::optional<MarkupLink> link;
  bool operator==(const MarkedRun&) const = default;
};

struct MarkedLine {
  bool bullet = false;
  std::vector<MarkedRun> runs;
  bool operator==(const MarkedLine&) const = default;
};

/// What a backslash before it makes a sign that is shown.
inline constexpr std::string_view escapableSigns = "*-[\\";
inline constexpr std::string_view bulletSign = "\u2022 ";

constexpr bool isMarkupBlank(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}

/// Parses UTF-8 text and returns as many lines as it has. Takes time and memory linear in the text.
std::vector<MarkupLine> parsedMarkup(std::string_view text);
/// Returns the visible content of the lines, in which neighbouring runs have different styles or
/// links, without blank lines at the beginning and the end.
std::vector<MarkedLine> markedLines(std::string_view text);

/// Returns a text that is plain but for links in runs, whose styles are plain.
std::vector<MarkedRun> linkedRuns(std::string_view plain);
/// Returns what is shown of such a text where links cannot be followed.
std::string withoutLinks(std::string_view plain);
/// Returns the target as it is written behind a link's words: "(#view=2)".
std::string writtenTarget(const MarkupLink& link);

/// Returns what an annotation of that kind shows where styles are not available: a callout without
/// markers, with bullets for lists. The texts of other kinds are plain anyway.
std::string plainText(AnnotationKind kind, const std::string& text);
/// Returns the plain text in the language, or the scene's own where there is none.
std::string plainTextIn(const Annotation& annotation, const std::string& language);

}  // namespace sline::model
