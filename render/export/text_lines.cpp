// SPDX-License-Identifier: Apache-2.0
#include "render/export/text_lines.h"

#include <QStringList>

namespace sline::render {

void append(TextLine& line, QStringView text, const model::LetterStyle& style) {
  if (line.runs.empty() || line.runs.back().style != style)
    line.runs.push_back({.text = {}, .style = style});
  line.runs.back().text += text;
}

QString plainText(const TextLine& line) {
  QString text;
  for (const TextRun& run : line.runs)
    text += run.text;
  return text;
}

QString plainText(const std::vector<TextLine>& lines, QChar between) {
  QStringList texts;
  for (const TextLine& line : lines)
    texts << plainText(line);
  return texts.join(between);
}

}  // namespace sline::render
