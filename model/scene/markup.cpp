// SPDX-License-Identifier: Apache-2.0
#include "model/scene/markup.h"

#include <algorithm>
#include <array>
#include <utility>

#include "model/scene/label_words.h"

namespace sline::model {

namespace {

constexpr std::size_t boldLength = 2;
constexpr std::size_t italicLength = 1;
/// The longest run of asterisks with a meaning ends both styles and begins both.
constexpr std::size_t longestMarker = 2 * (boldLength + italicLength);

constexpr std::array linkKeys{std::pair(MarkupLink::To::structure, std::string_view("#structure=")),
                              std::pair(MarkupLink::To::view, std::string_view("#view="))};
/// A longer name of a link's target is none, so that a line is read in linear time.
constexpr std::size_t longestName = 400;  // bytes

/// Holds where a link stands in a text: "[words](#key=name)".
struct LinkPlace {
  std::size_t open = 0;   ///< its first bracket
  std::size_t close = 0;  ///< the bracket behind its words
  std::size_t end = 0;    ///< behind all of it
  MarkupLink link;
};

bool isBlankText(std::string_view text) {
  return std::all_of(text.begin(), text.end(), isMarkupBlank);
}

/// Returns the target that is written at the text's beginning, and behind which byte it ends.
std::optional<std::pair<MarkupLink, std::size_t>> targetAt(std::string_view text) {
  for (const auto& [to, key] : linkKeys) {
    if (!text.starts_with('(') || !text.substr(1).starts_with(key))
      continue;
    const std::size_t begin = 1 + key.size();
    const std::size_t last = std::min(text.size(), begin + longestName + 1);
    int within = 0;  // names may have brackets in pairs
    for (std::size_t i = begin; i < last; ++i)
      if (text[i] == '(')
        ++within;
      else if (text[i] == ')' && within-- == 0)
        return std::pair(MarkupLink{to, std::string(text.substr(begin, i - begin))}, i + 1);
  }
  return std::nullopt;
}

/// Returns the links between two bytes of a line, in order. `escapes`: a backslash before a bracket
/// makes it one that is shown.
std::vector<LinkPlace> linkPlaces(std::string_view text, std::size_t begin, std::size_t end,
                                  bool escapes) {
  std::vector<LinkPlace> places;
  std::optional<std::size_t> open;
  for (std::size_t i = begin; i < end; ++i) {
    if (escapes && text[i] == '\\' && i + 1 < end &&
        escapableSigns.find(text[i + 1]) != text.npos) {
      ++i;
    } else if (text[i] == '[') {
      open = i;
    } else if (text[i] == ']' && open) {
      const std::size_t first = *std::exchange(open, std::nullopt);
      if (isBlankText(text.substr(first + 1, i - first - 1)))
        continue;
      if (auto target = targetAt(text.substr(i + 1, end - i - 1))) {
        places.push_back({first, i, i + 1 + target->second, std::move(target->first)});
        i = places.back().end - 1;
      }
    }
  }
  return places;
}

std::size_t lengthOf(const LetterStyle& style) {
  return (style.bold ? boldLength : 0) + (style.italic ? italicLength : 0);
}

/// A piece is plain bytes or a run of asterisks: those that end a style come first, those that
/// begin one last, others between them.
struct Piece {
  std::size_t begin = 0;
  std::size_t end = 0;
  bool asterisks = false;
  std::optional<std::size_t> link;
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
    const std::vector<LinkPlace> links = linkPlaces(m_text, m_line.content, m_end, true);
    std::size_t plain = m_line.content;
    std::optional<std::size_t> link;
    const auto flush = [&](std::size_t end) {
      if (end > plain)
        m_pieces.push_back({.begin = plain, .end = end, .link = link});
    };
    for (std::size_t i = m_line.content; i < m_end;) {
      const std::size_t next = m_line.links.size();
      if (link && i == links[*link].close) {
        flush(i);
        i = plain = links[*link].end;
        link.reset();
      } else if (next < links.size() && i == links[next].open) {
        flush(i);
        plain = ++i;
        link = next;
        m_line.links.push_back(links[next].link);
      } else if (m_text[i] == '\\' && i + 1 < m_end &&
                 escapableSigns.find(m_text[i + 1]) != std::string_view::npos) {
        flush(i);
        plain = i + 1;
        i += 2;
      } else if (m_text[i] == '*') {
        flush(i);
        const std::size_t end = std::min(m_text.find_first_not_of('*', i), m_end);
        m_pieces.push_back({.begin = i, .end = end, .asterisks = true, .link = link});
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
      m_line.spans.push_back({begin, end, m_style, piece.link});
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
    const std::optional<MarkupLink> link =
        span.link ? std::optional(line.links[*span.link]) : std::nullopt;
    if (marked.runs.empty() || marked.runs.back().style != span.style ||
        marked.runs.back().link != link)
      marked.runs.push_back({.text = {}, .style = span.style, .link = link});
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

std::vector<MarkedRun> linkedRuns(std::string_view plain) {
  std::vector<MarkedRun> runs;
  const auto add = [&runs](std::string_view text, const std::optional<MarkupLink>& link) {
    if (runs.empty() || runs.back().link != link)
      runs.push_back({.text = {}, .style = {}, .link = link});
    runs.back().text += text;
  };
  std::size_t at = 0;
  for (std::size_t begin = 0; begin < plain.size();) {
    const std::size_t end = std::min(plain.find('\n', begin), plain.size());
    for (const LinkPlace& place : linkPlaces(plain, begin, end, false)) {
      if (place.open > at)
        add(plain.substr(at, place.open - at), std::nullopt);
      add(plain.substr(place.open + 1, place.close - place.open - 1), place.link);
      at = place.end;
    }
    begin = end + 1;
  }
  if (at < plain.size())
    add(plain.substr(at), std::nullopt);
  return runs;
}

std::string withoutLinks(std::string_view plain) {
  std::string words;
  for (const MarkedRun& run : linkedRuns(plain))
    words += run.text;
  return words;
}

std::string writtenTarget(const MarkupLink& link) {
  const std::string_view key = linkKeys[std::size_t(link.to)].second;
  return "(" + std::string(key) + link.name + ")";
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
