// SPDX-License-Identifier: Apache-2.0
#include "model/import/molecules/cif_tokens.h"

#include <algorithm>

namespace sline::model {

const CifToken& CifTokens::peek() {
  if (!m_peeked)
    m_token = read();
  m_peeked = true;
  return m_token;
}

CifToken CifTokens::next() {
  peek();
  m_peeked = false;
  return m_token;
}

CifToken CifTokens::read() {
  while (true) {
    m_at.skipSpace();
    if (m_at.peek() != '#' || m_at.atEnd())
      break;
    m_at.skipLine();
  }
  m_place = m_at.at();
  if (m_at.atEnd())
    return {};
  const char c = m_at.peek();
  const bool lineBegins = m_at.at() == m_begin || TextCursor::isLineEnd(m_at.at()[-1]);
  if (c == ';' && lineBegins)
    return readText();
  if (c == '\'' || c == '"')
    return readQuoted(c);
  return readWord();
}

CifToken CifTokens::readText() {
  const char* begin = m_at.at() + 1;
  for (const char* p = begin; p != m_at.end(); ++p)
    if (*p == ';' && TextCursor::isLineEnd(p[-1])) {
      m_at.moveTo(p + 1);
      const char* end = p - 1;
      if (end > begin && *end == '\n' && end[-1] == '\r')
        --end;
      return {CifToken::Kind::value,
              {begin, std::size_t(std::max<std::ptrdiff_t>(0, end - begin))},
              true};
    }
  m_broken = true;
  m_at.moveTo(m_at.end());
  return {};
}

CifToken CifTokens::readQuoted(char quote) {
  // A quote ends the value only where a blank follows: 'it's one value'.
  const char* begin = m_at.at() + 1;
  for (const char* p = begin; p != m_at.end() && !TextCursor::isLineEnd(*p); ++p)
    if (*p == quote && (p + 1 == m_at.end() || TextCursor::isSpace(p[1]))) {
      m_at.moveTo(p + 1);
      return {CifToken::Kind::value, {begin, std::size_t(p - begin)}, true};
    }
  m_broken = true;
  return readWord();
}

CifToken CifTokens::readWord() {
  const std::string_view word = m_at.word();
  using Kind = CifToken::Kind;
  if (word.starts_with('_'))
    return {Kind::name, word};
  if (word.size() >= 5 && equalsIgnoringCase(word.substr(0, 5), "data_"))
    return {Kind::data, word.substr(5)};
  if (equalsIgnoringCase(word, "loop_"))
    return {Kind::loop, word};
  if (equalsIgnoringCase(word, "global_") || equalsIgnoringCase(word, "stop_") ||
      (word.size() >= 5 && equalsIgnoringCase(word.substr(0, 5), "save_")))
    return {Kind::reserved, word};
  return {Kind::value, word};
}

}  // namespace sline::model
