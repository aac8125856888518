// SPDX-License-Identifier: Apache-2.0
// Walks through text in memory: words, numbers, lines. Numbers are read the same in every locale.
#pragma once

#include <cstdint>
#include <string_view>

namespace sline::model {

/// Is a reading position in [at, end). Lines end with \n, \r\n or \r.
class TextCursor {
 public:
  TextCursor(const char* begin, const char* end) : m_at(begin), m_end(end) {}
  explicit TextCursor(std::string_view text) : TextCursor(text.data(), text.data() + text.size()) {}

  const char* at() const { return m_at; }
  const char* end() const { return m_end; }
  bool atEnd() const { return m_at == m_end; }
  char peek() const { return m_at == m_end ? '\0' : *m_at; }
  void moveTo(const char* place) { m_at = place; }

  static bool isBlank(char c) { return c == ' ' || c == '\t'; }
  static bool isLineEnd(char c) { return c == '\n' || c == '\r'; }
  static bool isSpace(char c) { return isBlank(c) || isLineEnd(c) || c == '\f' || c == '\v'; }

  /// Skips blanks in the line, and a backslash that ends the line together with that line end.
  void skipBlanks() {
    while (m_at != m_end) {
      if (isBlank(*m_at))
        ++m_at;
      else if (*m_at != '\\' || !skipContinuation())
        return;
    }
  }
  /// Skips blanks and line ends.
  void skipSpace() {
    while (m_at != m_end && isSpace(*m_at))
      ++m_at;
  }
  /// Moves to the beginning of the next line.
  void skipLine();
  bool atLineEnd() const { return m_at == m_end || isLineEnd(*m_at); }
  /// Returns the rest of the line without blanks around it; moves to the next line.
  std::string_view restOfLine();
  /// Returns the text up to the next blank or line end; empty at one.
  std::string_view word();
  /// Returns the word at the position, which stays.
  std::string_view peekWord() const { return TextCursor(*this).word(); }

  /// Reads a decimal number at the position; "nan", "inf" and numbers that overflow give a
  /// non-finite value, a leading + is accepted. Returns false, without moving, where there is none
  /// or it runs into other text.
  bool number(float& value);
  bool number(double& value);
  /// Reads a whole number with sign; returns false, without moving, where there is none or it runs
  /// into letters, a dot or a sign.
  bool integer(std::int64_t& value);

 private:
  bool skipContinuation();
  const char* m_at;
  const char* m_end;
};

}  // namespace sline::model
