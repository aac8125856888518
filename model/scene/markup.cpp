// SPDX-License-Identifier: Apache-2.0
#include "model/scene/markup.h"

#include <algorithm>
#include <optional>

#include "model/scene/label_words.h"

namespace sline::model {

namespace {

constexpr std::size_t boldLength = 2;
constexpr std::size_t italicLength = 1;
/// The longest run of asterisks with a meaning ends both styles and begins both.
constexpr std::size_t longestMarker = 2 * (boldLength + italicLength);

std::size_t lengthOf(const LetterStyle& style) {
  return (style.bold ? boldLength : 0) + (style.italic ? italicLength : 0);
}

/// A piece is plain bytes or a run of asterisks: those that end a style come first, those that
/// begin one last, others between them.
struct Piece {
  std::size_t begin = 0;
  std::size_t end = 0;
  bool asterisks = false;
  LetterStyle ends;
  LetterStyle begins;
};

class LineParser {
 public:
  LineParser(std::string_view text, std::size_t begin, std::size_t end) : m_text(text) {
    m_line.begin = begin;
    m_line.end = end;
  }

  MarkupLine parse() {
    trim();
    split();
    for (std::size_t i = 0; i < m_pieces.size(); ++i)
      if (m_pieces[i].asterisks && m_pieces[i].end - m_pieces[i].begin <= longestMarker)
        pair(i);
    for (const Piece& piece : m_pieces)
      add(piece);
    return std::move(m_line);
  }

 private:
  void trim() {
    m_line.content = m_line.begin;
    m_end = m_line.end;
    while (m_line.content < m_end && isMarkupBlank(m_text[m_line.content]))
      ++m_line.content;
    while (m_end > m_line.content && isMarkupBlank(m_text[m_end - 1]))
      --m_end;
    if (m_end - m_line.content < 2 || m_text[m_line.content] != '-' ||
        !isMarkupBlank(m_text[m_line.content + 1]))
      return;
    m_line.bullet = true;
    ++m_line.content;
    while (isMarkupBlank(m_text[m_line.content]))
      ++m_line.content;
  }

  void split() {
    std::size_t plain = m_line.content;
    const auto flush = [&](std::size_t end) {
      if (end > plain)
        m_pieces.push_back({.begin = plain, .end = end});
    };
    for (std::size_t i = m_line.content; i < m_end;) {
      if (m_text[i] == '\\' && i + 1 < m_end &&
          std::string_view("*-\\").find(m_text[i + 1]) != std::string_view::npos) {
        flush(i);
        plain = i + 1;
        i += 2;
      } else if (m_text[i] == '*') {
        flush(i);
        const std::size_t end = std::min(m_text.find_first_not_of('*', i), m_end);
        m_pieces.push_back({.begin = i, .end = end, .asterisks = true});
        i = plain = end;
      } else {
        ++i;
      }
    }
    flush(m_end);
  }

  /// Finds which styles the asterisks end, and which they may begin.
  void pair(std::size_t at) {
    Piece& piece = m_pieces[at];
    std::size_t rest = piece.end - piece.begin;
    if (piece.begin > m_line.content && !isMarkupBlank(m_text[piece.begin - 1])) {
      piece.ends = endedBy(rest);
      rest -= lengthOf(piece.ends);
      end(piece.ends);
    }
    if (piece.end == m_end || isMarkupBlank(m_text[piece.end]) || rest > boldLength + italicLength)
      return;
    if (rest >= boldLength)
      m_bold = at;
    if (rest % boldLength == italicLength)
      m_italic = at;
  }

  LetterStyle endedBy(std::size_t asterisks) const {
    if (m_bold && m_italic && asterisks >= boldLength + italicLength)
      return {.bold = true, .italic = true};
    if (m_bold && asterisks >= boldLength)
      return {.bold = true};
    return {.italic = m_italic && asterisks % boldLength == italicLength};
  }

  /// Ends the style; a style that began within the one that ends stays without a partner.
  void end(const LetterStyle& style) {
    if (style.bold)
      m_pieces[*m_bold].begins.bold = true;
    if (style.italic)
      m_pieces[*m_italic].begins.italic = true;
    const bool within = style.bold != style.italic && m_bold && m_italic &&
                        (style.bold ? *m_italic > *m_bold : *m_bold > *m_italic);
    if (style.bold || within)
      m_bold.reset();
    if (style.italic || within)
      m_italic.reset();
  }

  void add(const Piece& piece) {
    m_style.bold = m_style.bold && !piece.ends.bold;
    m_style.italic = m_style.italic && !piece.ends.italic;
    const std::size_t begin = piece.begin + lengthOf(piece.ends);
    const std::size_t end = piece.end - lengthOf(piece.begins);
    if (begin < end)
      m_line.spans.push_back({begin, end, m_style});
    m_style.bold = m_style.bold || piece.begins.bold;
    m_style.italic = m_style.italic || piece.begins.italic;
  }

  std::string_view m_text;
  MarkupLine m_line;
  std::size_t m_end = 0;  ///< end of the line without its trailing blanks
  std::vector<Piece> m_pieces;
  std::optional<std::size_t> m_bold;  ///< index of the piece that may begin bold
  std::optional<std::size_t> m_italic;
  LetterStyle m_style;
};

MarkedLine markedLine(std::string_view text, const MarkupLine& line) {
  MarkedLine marked{.bullet = line.bullet, .runs = {}};
  for (const MarkupSpan& span : line.spans) {
    if (marked.runs.empty() || marked.runs.back().style != span.style)
      marked.runs.push_back({.text = {}, .style = span.style});
    marked.runs.back().text += text.substr(span.begin, span.end - span.begin);
  }
  return marked;
}

}  // namespace

std::vector<MarkupLine> parsedMarkup(std::string_view text) {
  std::vector<MarkupLine> lines;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    lines.push_back(LineParser(text, begin, end).parse());
    begin = end + 1;
  }
  return lines;
}

std::vector<MarkedLine> markedLines(std::string_view text) {
  std::vector<MarkedLine> marked;
  std::size_t lines = 0;
  for (const MarkupLine& line : parsedMarkup(text)) {
    if (line.spans.empty() && marked.empty())
      continue;
    marked.push_back(markedLine(text, line));
    if (!line.spans.empty())
      lines = marked.size();
  }
  marked.resize(lines);
  return marked;
}

std::string plainText(AnnotationKind kind, const std::string& text) {
  if (kind != AnnotationKind::callout)
    return text;
  std::string plain;
  const std::vector<MarkedLine> lines = markedLines(text);
  for (const MarkedLine& line : lines) {
    if (&line != &lines.front())
      plain += '\n';
    if (line.bullet)
      plain += bulletSign;
    for (const MarkedRun& run : line.runs)
      plain += run.text;
  }
  return plain;
}

std::string plainTextIn(const Annotation& annotation, const std::string& language) {
  return plainText(annotation.kind, writtenIn(annotation, language));
}

}  // namespace sline::model
