// SPDX-License-Identifier: Apache-2.0
#include "app/cli/jobs/json_positions.h"

#include <algorithm>

#include "app/cli/files/json_values.h"

namespace sline::cli {

namespace {

/// Reads a list once, from its beginning to its end.
class Scan {
 public:
  explicit Scan(std::string_view text) : m_text(text) {}

  std::vector<ElementPositions> list() {
    while (m_at < m_text.size())
      take();
    return std::move(m_elements);
  }

 private:
  void step() {
    const char now = m_text[m_at++];
    if (now == '\n')
      m_place = {m_place.line + 1, 1};
    else
      m_place.column += m_at < m_text.size() && isWithin(m_text[m_at]) ? 0 : 1;
  }
  /// Tells whether the byte belongs to a character that began before it.
  static bool isWithin(char byte) { return (static_cast<unsigned char>(byte) & 0xC0u) == 0x80u; }

  void take() {
    const char now = m_text[m_at];
    const bool blank = now == ' ' || now == '\t' || now == '\r' || now == '\n';
    const bool parting = now == ',' || now == ']' || now == '}' || now == ':';
    if (m_depth == 1 && !blank && !parting && m_begins) {
      m_elements.push_back({m_place, {}});
      m_begins = false;
    }
    if (now == '"') {
      takeString();
      return;
    }
    if (now == '[' || now == '{') {
      ++m_depth;
      m_begins = m_begins || m_depth == 1;
      m_keyNext = m_depth == 2 && now == '{';
    } else if (now == ']' || now == '}') {
      --m_depth;
    } else if (now == ',' && m_depth == 1) {
      m_begins = true;
    } else if (now == ',' && m_depth == 2) {
      m_keyNext = true;
    }
    step();
  }

  void takeString() {
    const std::size_t start = m_at;
    const TextPosition place = m_place;
    step();
    while (m_at < m_text.size() && m_text[m_at] != '"') {
      if (m_text[m_at] == '\\')
        step();
      if (m_at < m_text.size())
        step();
    }
    if (m_at < m_text.size())
      step();
    // A list within the list has commas at that depth, too, but its keys are never asked for.
    if (m_depth != 2 || !m_keyNext || m_elements.empty())
      return;
    m_keyNext = false;
    const Json name = Json::parse(m_text.substr(start, m_at - start), nullptr, false);
    if (name.is_string())
      m_elements.back().keys.push_back({name.get<std::string>(), place});
  }

  std::string_view m_text;
  std::size_t m_at = 0;
  TextPosition m_place;
  int m_depth = 0;
  bool m_begins = false;   ///< the next value of the list is another element
  bool m_keyNext = false;  ///< the next text of the object is a key
  std::vector<ElementPositions> m_elements;
};

}  // namespace

std::string TextPosition::text() const {
  return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

TextPosition textPositionAt(std::string_view text, std::size_t byte) {
  TextPosition place;
  for (const char each : text.substr(0, std::min(byte, text.size())))
    if (each == '\n')
      place = {place.line + 1, 1};
    else
      place.column += (static_cast<unsigned char>(each) & 0xC0u) == 0x80u ? 0 : 1;
  return place;
}

std::vector<ElementPositions> elementPositions(std::string_view text) {
  return Scan(text).list();
}

}  // namespace sline::cli
