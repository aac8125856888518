// SPDX-License-Identifier: Apache-2.0
#include "render/lettering/patient_text.h"

#include <algorithm>

namespace sline::render {

std::vector<std::unique_ptr<QTextLayout>> patientParagraphs(const std::string& text,
                                                            float widthMm) {
  constexpr float widestLine = 165.0f;  // longer ones are hard to read
  const qreal scale = qreal(patientPoints * millimetresPerPoint) / labelFontPixels;
  std::vector<std::unique_ptr<QTextLayout>> paragraphs;
  for (const QString& line : QString::fromStdString(text).split(QLatin1Char('\n'))) {
    const QString words = line.simplified();
    if (words.isEmpty()) {
      paragraphs.push_back(nullptr);
      continue;
    }
    auto layout = std::make_unique<QTextLayout>(words, labelFont());
    QTextOption option;
    option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    layout->setTextOption(option);
    layout->beginLayout();
    for (QTextLine one = layout->createLine(); one.isValid(); one = layout->createLine())
      one.setLineWidth(qreal(std::min(widestLine, widthMm)) / scale);
    layout->endLayout();
    paragraphs.push_back(std::move(layout));
  }
  return paragraphs;
}

float patientTextHeight(const std::string& text, float widthMm) {
  float height = 0.0f;
  for (const auto& paragraph : patientParagraphs(text, widthMm))
    height +=
        patientParagraphSpace + (paragraph ? float(paragraph->lineCount()) * patientLeading : 0.0f);
  return height;
}

}  // namespace sline::render
