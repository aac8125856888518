// SPDX-License-Identifier: Apache-2.0
#include "render/export/pdf/sheet_header.h"

#include "render/export/pdf/pdf_pages.h"
#include "render/export/pdf/sheet_lists.h"
#include "render/lettering/label_texts.h"

namespace sline::render {

namespace {

constexpr float titlePoints = 18.0f;
constexpr float leastTitlePoints = 10.0f;
constexpr float kindPoints = 11.0f;

void setInkedLine(QPainter& painter, const QString& text, const LetteringText& how) {
  LetteringText line = how;
  line.lines = {text};
  setText(painter, line);
}

}  // namespace

void setLine(QPainter& painter, const QString& text, const glm::vec2& at, float points,
             TextAnchor anchor) {
  setInkedLine(painter, text,
               {.lines = {}, .at = at, .points = points, .anchor = anchor, .ink = textInk});
}

void setQuietLine(QPainter& painter, const QString& text, const glm::vec2& at, float points,
                  TextAnchor anchor) {
  setInkedLine(painter, text,
               {.lines = {}, .at = at, .points = points, .anchor = anchor, .ink = quietInk});
}

bool beginSheetPage(SheetPages& pages, PageCount& count, const SheetLayout& layout,
                    const SheetHeader& header) {
  if (count.page > 0)
    pages.newPage();
  ++count.page;
  QPainter& painter = pages.painter();
  painter.setRenderHint(QPainter::Antialiasing);
  const LabelBox& content = layout.content;
  const float width = content.size().x;
  const float baseline = content.low.y - 7.0f;
  const float room =
      width - (header.kind.isEmpty() ? 0.0f : textWidthMm(header.kind, kindPoints) + 8.0f);
  bool whole = true;
  if (!header.title.isEmpty()) {
    float points = titlePoints;
    while (points > leastTitlePoints && textWidthMm(header.title, points) > room)
      points -= 0.5f;
    const QString fitted = elidedText(header.title, points, room);
    whole = fitted == header.title;
    setLine(painter, fitted, {content.low.x, baseline}, points);
  }
  if (!header.kind.isEmpty())
    setQuietLine(painter, header.kind, {content.high.x, baseline}, kindPoints, TextAnchor::end);
  if (!header.title.isEmpty() || !header.kind.isEmpty())
    setRule(painter, {content.low.x, baseline + 2.6f}, width, 0.25f);
  if (count.total > 1)
    setQuietLine(painter, QStringLiteral("%1 / %2").arg(count.page).arg(count.total),
                 {content.high.x, layout.paper.y - 8.5f}, 7.5f, TextAnchor::end);
  return whole;
}

}  // namespace sline::render
