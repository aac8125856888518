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
  return clean.toHtmlEscaped()
      .replace(QLatin1Char('['), QLatin1String("&#91;"))
      .replace(QLatin1Char('{'), QLatin1String("&#123;"))
      .toStdString();
}

std::string htmlOf(const AnkiFace& face) {
  if (face.empty())
    return {};
  // Without a style sheet of its own, so that it looks the same in notes of every type.
  std::string html = face.words.empty() ? std::string() : "<div>" + htmlText(face.words) + "</div>";
  html += "<div style=\"position:relative;display:inline-block\"><img src=\"" + face.ground +
          "\" alt=\"" + htmlText(face.shows) +
          "\" style=\"display:block;max-width:100%;max-height:75vh\">";
  if (!face.over.empty())
    html += "<img src=\"" + face.over +
            "\" alt=\"\" style=\"position:absolute;left:0;top:0;width:100%;height:100%\">";
  return html + "</div>";
}

std::string AnkiDeck::nameOf(const AnkiPart& part) const {
  // Two colons would part a deck from those in it.
  const QString title = QString::fromStdString(part.title)
                            .replace(QLatin1String("::"), QLatin1String(": "))
                            .simplified();
  return title.isEmpty() ? name : name + "::" + title.toStdString();
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
