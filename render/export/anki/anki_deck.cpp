// SPDX-License-Identifier: Apache-2.0
#include "render/export/anki/anki_deck.h"

#include <QString>

namespace sline::render {

std::string htmlText(std::string_view text) {
  QString clean = QString::fromUtf8(text.data(), qsizetype(text.size())).simplified();
  // Characters that no text shows could end a field of Anki's.
  for (QChar& c : clean)
    if (c.category() == QChar::Other_Control)
      c = QChar::ReplacementCharacter;
  return clean.toHtmlEscaped().toStdString();
}

std::string htmlPicture(const std::string& name, const std::string& shows) {
  return "<img src=\"" + name + "\" alt=\"" + htmlText(shows) + "\">";
}

std::string ankiTag(std::string_view name) {
  QString tag = QString::fromUtf8(name.data(), qsizetype(name.size())).simplified();
  for (QChar& c : tag)
    if (!c.isLetterOrNumber() && c != u'-' && !c.isSurrogate() && !c.isMark())
      c = u'_';
  return tag.toStdString();
}

std::uint64_t fingerprintOf(std::string_view bytes) {
  std::uint64_t hash = 14695981039346656037ull;
  for (const char byte : bytes)
    hash = (hash ^ std::uint8_t(byte)) * 1099511628211ull;
  return hash;
}

std::string hexOf(std::uint64_t value) {
  std::string text;
  for (int shift = 60; shift >= 0; shift -= 4)
    text.push_back("0123456789abcdef"[value >> shift & 15]);
  return text;
}

}  // namespace sline::render
