// SPDX-License-Identifier: Apache-2.0
#include "render/export/encoding/xml_text.h"

#include <array>
#include <cstdint>

namespace sline::render {

namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD";

/// Returns how many bytes the character that starts the text takes; 0 where it is not a character,
/// by the shortest form alone (RFC 3629).
std::size_t utf8Length(std::string_view text, std::uint32_t& code) {
  const auto byte = [&text](std::size_t i) { return std::uint8_t(text[i]); };
  const std::uint8_t first = byte(0);
  if (first < 0x80) {
    code = first;
    return 1;
  }
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : first >= 0xC0 ? 2 : 0;
  if (length == 0 || first > 0xF4 || text.size() < length)
    return 0;
  code = first & (0x7Fu >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80)
      return 0;
    code = (code << 6) | (byte(i) & 0x3Fu);
  }
  constexpr std::array<std::uint32_t, 5> least{0, 0, 0x80, 0x800, 0x10000};
  return code >= least[length] && code <= 0x10FFFF ? length : 0;
}

/// Tells whether the code is a Char of XML 1.0, without line breaks, tabs and the controls that XML
/// discourages.
bool isXmlCharacter(std::uint32_t code) {
  return (code >= 0x20 && code < 0x7F) || (code >= 0xA0 && code <= 0xD7FF) ||
         (code >= 0xE000 && code <= 0xFFFD) || (code >= 0x10000 && (code & 0xFFFE) != 0xFFFE);
}

}  // namespace

std::string xmlText(std::string_view text) {
  std::string safe;
  safe.reserve(text.size());
  while (!text.empty()) {
    std::uint32_t code = 0;
    const std::size_t length = utf8Length(text, code);
    if (length == 0 || !isXmlCharacter(code))
      safe += replacement;
    else if (code == '&')
      safe += "&amp;";
    else if (code == '<')
      safe += "&lt;";
    else if (code == '>')
      safe += "&gt;";
    else if (code == '"')
      safe += "&quot;";
    else if (code == '\'')
      safe += "&#39;";
    else
      safe += text.substr(0, length);
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return safe;
}

std::string plainLine(std::string_view text) {
  std::string line;
  while (!text.empty()) {
    std::uint32_t code = 0;
    const std::size_t length = utf8Length(text, code);
    const bool breaks = length > 0 && (code == '\n' || code == '\r' || code == '\t');
    if (breaks || (length > 0 && code == ' '))
      line += line.empty() || line.back() == ' ' ? "" : " ";
    else if (length == 0 || !isXmlCharacter(code))
      line += replacement;
    else
      line += text.substr(0, length);
    text.remove_prefix(length == 0 ? 1 : length);
  }
  if (line.ends_with(' '))
    line.pop_back();
  return line;
}

}  // namespace sline::render
