// SPDX-License-Identifier: Apache-2.0
// The words of a CIF file (Hall, Allen & Brown, Acta Cryst. A47, 1991): names of items, values with
// and without quotes, text between lines that begin with a semicolon, reserved words; comments are
// passed over.
#pragma once

#include <string_view>

#include "model/import/readers/text_cursor.h"

namespace sline::model {

struct CifToken {
  enum class Kind { end, data, loop, reserved, name, value } kind = Kind::end;
  std::string_view text;  ///< without quotes; of `data` the block's name
  bool quoted = false;    ///< so that '?' and '.' mean themselves

  /// A value that says something: neither unknown (?) nor inapplicable (.).
  bool says() const { return kind == Kind::value && (quoted || (text != "?" && text != ".")); }
};

class CifTokens {
 public:
  explicit CifTokens(std::string_view text) : m_at(text), m_begin(text.data()) {}

  const CifToken& peek();
  CifToken next();
  /// Where the token that `peek` shows begins.
  const char* place() { return peek(), m_place; }
  /// A text or quoted value that never ended.
  bool broken() const { return m_broken; }

 private:
  CifToken read();
  CifToken readText();
  CifToken readQuoted(char quote);
  CifToken readWord();

  TextCursor m_at;
  const char* m_begin;
  const char* m_place = nullptr;
  CifToken m_token;
  bool m_peeked = false;
  bool m_broken = false;
};

}  // namespace sline::model
