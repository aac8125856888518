// SPDX-License-Identifier: Apache-2.0
#include "model/edit/letter_style.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace sline::model {

namespace {

/// Holds a byte that is shown.
struct ShownByte {
  std::size_t source = 0;
  char byte = 0;
  LetterStyle style;
  std::optional<std::size_t> link;  ///< its place among the line's links
  bool selected = false;

  bool blank() const { return isMarkupBlank(byte); }
};

/// Returns the member of the style that belongs to a mark.
bool& part(LetterStyle& style, LetterMark mark) {
  return mark == LetterMark::bold ? style.bold : style.italic;
}

std::string_view markerOf(LetterMark mark) {
  return mark == LetterMark::bold ? "**" : "*";
}

std::vector<ShownByte> shownBytes(std::string_view text, const MarkupLine& line) {
  std::vector<ShownByte> shown;
  for (const MarkupSpan& span : line.spans)
    for (std::size_t i = span.begin; i < span.end; ++i)
      shown.push_back({.source = i, .byte = text[i], .style = span.style, .link = span.link});
  return shown;
}

/// Holds a line's words and where they lead.
struct LineWords {
  const std::vector<ShownByte>& shown;
  const std::vector<MarkupLink>& links;

  std::optional<MarkupLink> link(const ShownByte& byte) const {
    return byte.link ? std::optional(links[*byte.link]) : std::nullopt;
  }
};

bool sameWords(const LineWords& a, const LineWords& b) {
  return std::equal(a.shown.begin(), a.shown.end(), b.shown.begin(), b.shown.end(),
                    [&](const ShownByte& x, const ShownByte& y) {
                      return x.byte == y.byte &&
                             (x.blank() || (x.style == y.style && a.link(x) == b.link(y)));
                    });
}

enum class Escapes { asTyped, all };

/// Writes a line's words with markers for their styles.
class LineWriter {
 public:
  LineWriter(std::string_view text, const LineWords& words, Escapes escapes)
      : m_text(text),
        m_shown(words.shown),
        m_links(words.links),
        m_escapes(escapes),
        m_lasts(words.shown.size()) {
    // The marker of the style that lasts longer is the outer one.
    std::size_t bold = m_shown.size();
    std::size_t italic = m_shown.size();
    for (std::size_t i = m_shown.size(); i-- > 0;) {
      if (!m_shown[i].blank() && !m_shown[i].style.bold)
        bold = i;
      if (!m_shown[i].blank() && !m_shown[i].style.italic)
        italic = i;
      m_lasts[i] = {bold, italic};
    }
  }

  /// Returns the line as written; `places` receives the positions of the shown bytes in it.
  std::string written(std::vector<std::size_t>& places) {
    places.clear();
    for (std::size_t i = 0; i < m_shown.size(); ++i) {
      if (!m_shown[i].blank())
        turnTo(i);
      if (m_shown[i].blank())
        m_blanks += m_shown[i].byte;
      else if (escaped(i))
        m_written += '\\';
      places.push_back(m_written.size());
      if (!m_shown[i].blank())
        m_written += m_shown[i].byte;
    }
    closeLink();
    return m_written + m_blanks;
  }

 private:
  /// Closes and opens markers: ends stand right behind the word before, beginnings right before the
  /// next.
  void turnTo(std::size_t i) {
    LetterStyle style = m_shown[i].style;
    const bool another = m_shown[i].link != m_link;
    if (another)
      closeLink();
    const auto lasts = [&](LetterMark mark) { return part(style, mark); };
    while (!std::all_of(m_open.begin(), m_open.end(), lasts))
      close();
    m_written += std::exchange(m_blanks, {});
    if (another && m_shown[i].link)
      m_written += '[';
    m_link = m_shown[i].link;
    std::vector<LetterMark> come;
    for (const LetterMark mark : {LetterMark::bold, LetterMark::italic})
      if (lasts(mark) && std::find(m_open.begin(), m_open.end(), mark) == m_open.end())
        come.push_back(mark);
    if (come.size() == 2 && m_lasts[i].second > m_lasts[i].first)
      std::swap(come[0], come[1]);
    for (const LetterMark mark : come) {
      m_written += markerOf(mark);
      m_open.push_back(mark);
    }
  }

  void close() {
    m_written += markerOf(m_open.back());
    m_open.pop_back();
  }

  /// Closes all markers and, where one is open, the link around them.
  void closeLink() {
    while (!m_open.empty())
      close();
    if (m_link)
      m_written += ']' + writtenTarget(m_links[*m_link]);
    m_link.reset();
  }

  bool escaped(std::size_t i) const {
    const ShownByte& byte = m_shown[i];
    if (m_escapes == Escapes::all)
      return byte.byte == '*' || byte.byte == '[' || byte.byte == '\\' ||
             (byte.byte == '-' && i == 0);
    const bool before = byte.source > 0 && m_text[byte.source - 1] == '\\';
    return before && (i == 0 || m_shown[i - 1].source + 1 != byte.source) &&
           escapableSigns.find(byte.byte) != std::string_view::npos;
  }

  std::string_view m_text;
  const std::vector<ShownByte>& m_shown;
  const std::vector<MarkupLink>& m_links;
  std::optional<std::size_t> m_link;  ///< the one that is open
  Escapes m_escapes;
  std::vector<std::pair<std::size_t, std::size_t>> m_lasts;  ///< bold, italic: where it ends
  std::string m_written;
  std::string m_blanks;  ///< blanks that have not been written yet
  std::vector<LetterMark> m_open;
};

/// Holds one line while its styles change.
struct Line {
  MarkupLine parsed;
  std::vector<ShownByte> shown;
  std::optional<std::pair<std::size_t, std::size_t>> selected;  ///< first and last selected byte
};

std::vector<Line> linesOf(std::string_view text, TextRange selection) {
  std::vector<Line> lines;
  for (MarkupLine& parsed : parsedMarkup(text)) {
    Line line{.parsed = std::move(parsed), .shown = {}, .selected = {}};
    line.shown = shownBytes(text, line.parsed);
    for (std::size_t i = 0; i < line.shown.size(); ++i) {
      ShownByte& byte = line.shown[i];
      byte.selected =
          !byte.blank() && byte.source >= selection.begin && byte.source < selection.end;
      if (byte.selected)
        line.selected = {line.selected ? line.selected->first : i, i};
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

/// Holds the line as it would be written, and the positions of its bytes in it.
struct Written {
  std::string text;
  std::vector<std::size_t> places;
};
std::optional<Written> writtenLine(std::string_view text, const Line& line, Escapes escapes) {
  Written written;
  const std::size_t lead = line.parsed.content - line.parsed.begin;
  written.text = std::string(text.substr(line.parsed.begin, lead)) +
                 LineWriter(text, {line.shown, line.parsed.links}, escapes).written(written.places);
  for (std::size_t& place : written.places)
    place += lead;
  std::size_t tail = line.parsed.end;
  while (tail > line.parsed.content && isMarkupBlank(text[tail - 1]))
    --tail;
  written.text += text.substr(tail, line.parsed.end - tail);
  const std::vector<MarkupLine> again = parsedMarkup(written.text);
  if (again.size() != 1 || again.front().bullet != line.parsed.bullet ||
      !sameWords({shownBytes(written.text, again.front()), again.front().links},
                 {line.shown, line.parsed.links}))
    return std::nullopt;
  return written;
}

MarkedText withPair(std::string_view text, std::size_t cursor, LetterMark mark) {
  const std::string_view marker = markerOf(mark);
  const std::size_t at = std::min(cursor, text.size());
  std::string made(text);
  const auto runBefore = at - (text.substr(0, at).find_last_not_of('*') + 1);
  const auto runAfter = std::min(text.find_first_not_of('*', at), text.size()) - at;
  if (runBefore == marker.size() && runAfter == marker.size()) {
    made.erase(at - marker.size(), 2 * marker.size());
    return {made, {at - marker.size(), at - marker.size()}};
  }
  made.insert(at, std::string(marker) + std::string(marker));
  return {made, {at + marker.size(), at + marker.size()}};
}

}  // namespace

MarkedText withLetterStyle(std::string_view text, TextRange selection, LetterMark mark) {
  if (selection.begin >= selection.end)
    return withPair(text, selection.end, mark);
  std::vector<Line> lines = linesOf(text, selection);
  const bool wanted = std::any_of(lines.begin(), lines.end(), [mark](Line& line) {
    return std::any_of(line.shown.begin(), line.shown.end(), [mark](ShownByte& byte) {
      return byte.selected && !part(byte.style, mark);
    });
  });
  MarkedText made{.text = {}, .selection = selection};
  bool any = false;
  for (Line& line : lines) {
    if (line.parsed.begin > 0)
      made.text += '\n';
    const std::size_t begin = made.text.size();
    if (line.selected)
      for (ShownByte& byte : line.shown)
        if (byte.selected)
          part(byte.style, mark) = wanted;
    std::optional<Written> written;
    if (line.selected && !(written = writtenLine(text, line, Escapes::asTyped)))
      written = writtenLine(text, line, Escapes::all);
    if (!written) {
      made.text += text.substr(line.parsed.begin, line.parsed.end - line.parsed.begin);
      continue;
    }
    made.text += written->text;
    if (!std::exchange(any, true))
      made.selection.begin = begin + written->places[line.selected->first];
    made.selection.end = begin + written->places[line.selected->second] + 1;
  }
  return any ? made : MarkedText{std::string(text), selection};
}

}  // namespace sline::model
