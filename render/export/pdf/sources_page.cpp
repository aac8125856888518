// SPDX-License-Identifier: Apache-2.0
#include "render/export/pdf/sources_page.h"

#include <algorithm>

#include "render/export/order/sheet_words.h"
#include "render/export/pdf/pdf_pages.h"
#include "render/export/plate/source_credits.h"
#include "render/lettering/patient_text.h"

namespace sline::render {

std::string sourcesText(const model::Scene& scene) {
  std::string text;
  for (const SourceLine& line : sourceLines(scene))
    text += (text.empty() ? "" : "\n") + line.text;
  return text;
}

void setSourcesPage(SheetPages& pages, const ExportOrder& order) {
  const std::string text = sourcesText(order.scene);
  if (order.sources != SourceCredits::page || text.empty())
    return;
  constexpr float margin = 6.0f;
  constexpr float headingPoints = 11.0f;
  const qreal scale = qreal(0.8f * patientPoints * millimetresPerPoint) / labelFontPixels;
  const float leading = 0.8f * patientLeading;
  const glm::vec2 size = order.page.sizeMm;
  float y = size.y;
  for (const auto& paragraph :
       patientParagraphs(text, std::max(size.x - 2.0f * margin, 1.0f) / 0.8f))
    for (int i = 0; paragraph && i < paragraph->lineCount(); ++i) {
      if (y + leading > size.y - margin) {
        pages.newPage();
        const QString heading = QString::fromUtf8(sheetWords(order.labels.language).sources);
        setText(pages.painter(), {.lines = {heading},
                                  .at = {margin, margin + capHeightMm(headingPoints)},
                                  .leading = 0.0f,
                                  .points = headingPoints,
                                  .anchor = TextAnchor::start,
                                  .ink = letteringColours().ink});
        y = margin + 2.0f * headingPoints * millimetresPerPoint;
      }
      const QTextLine one = paragraph->lineAt(i);
      QPainter& painter = pages.painter();
      painter.save();
      painter.setPen(painterColour(letteringColours().ink));
      painter.translate(qreal(margin), qreal(y));
      painter.scale(scale, scale);
      one.draw(&painter, QPointF(0.0, -one.y()));
      painter.restore();
      y += leading;
    }
}

}  // namespace sline::render
