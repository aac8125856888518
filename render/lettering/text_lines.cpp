// SPDX-License-Identifier: Apache-2.0
#include "render/lettering/text_lines.h"

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
  QString text;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (i > 0 && lines[i - 1].hyphenated && lines[i].joined)
      text.chop(1);
    else if (i > 0 && !lines[i].joined)
      text += between;
    text += plainText(lines[i]);
  }
  return text;
}

}  // namespace sline::render
