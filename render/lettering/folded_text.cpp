// SPDX-License-Identifier: Apache-2.0
#include "render/lettering/folded_text.h"

#include <QStringList>

#include "render/lettering/label_texts.h"
#include "render/lettering/text_lines.h"

namespace sline::render {

namespace {

/// Returns how many of the word's letters fit, at least one, and no half of a surrogate pair.
qsizetype fitting(const QString& word, float points, float widthMm) {
  qsizetype count = word.size();
  while (count > 1 && textWidthMm(TextLine(word.left(count)), points) > widthMm) {
    --count;
    if (count > 1 && word.at(count).isLowSurrogate())
      --count;
  }
  return count == 1 && word.size() > 1 && word.at(1).isLowSurrogate() ? 2 : count;
}

}  // namespace

std::vector<QString> foldedText(const QString& text, float points, float widthMm) {
  std::vector<QString> lines{{}};
  for (QString word : text.simplified().split(QChar(u' '), Qt::SkipEmptyParts)) {
    const QString longer = lines.back().isEmpty() ? word : lines.back() + QChar(u' ') + word;
    if (textWidthMm(TextLine(longer), points) <= widthMm) {
      lines.back() = longer;
      continue;
    }
    if (!lines.back().isEmpty())
      lines.emplace_back();
    while (true) {
      const qsizetype count = fitting(word, points, widthMm);
      lines.back() = word.left(count);
      word.remove(0, count);
      if (word.isEmpty())
        break;
      lines.emplace_back();
    }
  }
  return lines;
}

}  // namespace sline::render
