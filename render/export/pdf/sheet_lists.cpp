// SPDX-License-Identifier: Apache-2.0
#include "render/export/pdf/sheet_lists.h"

#include <QFontMetricsF>

#include "render/export/pdf/pdf_pages.h"
#include "render/export/pdf/style_samples.h"
#include "render/lettering/label_texts.h"

namespace sline::render {

namespace {

constexpr float swatch = 3.4f;
constexpr float rowText = 8.5f;     // points
constexpr float legendText = 7.5f;  // beside swatches
constexpr float smallText = 6.6f;   // of names that need two lines
constexpr float numberWidth = 6.5f;

struct Fitted {
  LetteringText text;
  bool whole = true;
};

/// Fits a text into one line or, where that is too long, two smaller ones; the second is shortened
/// if necessary.
Fitted fitted(const QString& text, const glm::vec2& middle, float width, float points) {
  LetteringText set{.lines = {text},
                    .at = middle + glm::vec2(0.0f, 0.5f * capHeightMm(points)),
                    .leading = 0.0f,
                    .points = points,
                    .anchor = TextAnchor::start,
                    .ink = textInk};
  if (textWidthMm(text, points) <= width)
    return {set};
  set.points = smallText;
  set.leading = 1.1f * smallText * millimetresPerPoint;
  QString first;
  QStringList words = text.split(QLatin1Char(' '), Qt::SkipEmptyParts);
  while (words.size() > 1) {
    const QString longer =
        first.isEmpty() ? words.front() : first + QLatin1Char(' ') + words.front();
    if (textWidthMm(longer, smallText) > width)
      break;
    first = longer;
    words.pop_front();
  }
  const QString meant = words.join(QLatin1Char(' '));
  const QString rest = elidedText(meant, smallText, width);
  set.lines = {rest};
  if (!first.isEmpty())
    set.lines.insert(set.lines.begin(), first);
  set.at.y =
      middle.y + 0.5f * capHeightMm(smallText) - 0.5f * set.leading * float(set.lines.size() - 1);
  return {set, rest == meant};
}

void setSwatch(QPainter& painter, const Colour& colour, const glm::vec2& corner) {
  painter.setPen(QPen(QColor(0, 0, 0, 90), 0.12));
  painter.setBrush(painterColour(colour));
  painter.drawPath(painterPath(roundedBox(corner, corner + swatch, 0.5f)));
}

void setNumber(QPainter& painter, int number, const glm::vec2& middle) {
  setText(painter, {.lines = {QString::number(number)},
                    .at = {middle.x + numberWidth - 2.2f, middle.y + 0.5f * capHeightMm(rowText)},
                    .leading = 0.0f,
                    .points = rowText,
                    .anchor = TextAnchor::end,
                    .ink = quietInk});
}

/// Sets a swatch, a sample and a name; returns false where the name had to be shortened.
bool setLegendRow(SheetPages& pages, const SheetRow& row, const glm::vec2& middle, float width) {
  QPainter& painter = pages.painter();
  if (row.number > 0)
    setNumber(painter, row.number, middle);
  const float indent = row.indented ? numberWidth : 0.0f;
  if (row.kind == RowKind::legend)
    setSwatch(painter, row.colour, middle + glm::vec2(indent, -0.5f * swatch));
  const glm::vec2 corner = middle + glm::vec2(indent + swatch + 1.2f, -0.5f * sampleMm.y);
  if (row.sample)
    pages.place(*row.sample, {corner, {corner, corner + sampleMm}});
  const float left = indent + swatch + sampleMm.x + 2.8f;
  const Fitted name = fitted(row.text, middle + glm::vec2(left, 0.0f), width - left, legendText);
  setText(painter, name.text);
  return name.whole;
}

}  // namespace

QString elidedText(const QString& text, float points, float width) {
  const qreal scale = qreal(points * millimetresPerPoint) / labelFontPixels;
  return QFontMetricsF(labelFont()).elidedText(text, Qt::ElideRight, qreal(width) / scale);
}

void setRule(QPainter& painter, const glm::vec2& from, float width, float pen) {
  painter.setPen(QPen(painterColour(ruleInk), qreal(pen)));
  painter.drawLine(QPointF(qreal(from.x), qreal(from.y)),
                   QPointF(qreal(from.x + width), qreal(from.y)));
}

bool setRow(SheetPages& pages, const SheetRow& row, const glm::vec2& at, float width) {
  QPainter& painter = pages.painter();
  const float height = rowHeight(row.kind);
  const glm::vec2 middle = at + glm::vec2(0.0f, 0.5f * height);
  switch (row.kind) {
    case RowKind::heading: {
      constexpr float points = 10.0f;
      setText(painter, {.lines = {row.text},
                        .at = {at.x, at.y + height - 2.8f},
                        .leading = 0.0f,
                        .points = points,
                        .anchor = TextAnchor::start,
                        .ink = textInk});
      setRule(painter, at + glm::vec2(0.0f, height - 1.4f), width);
      break;
    }
    case RowKind::group: {
      const QString name = elidedText(row.text, legendText, width);
      setText(painter, {.lines = {name},
                        .at = {at.x, at.y + height - 1.5f},
                        .leading = 0.0f,
                        .points = legendText,
                        .anchor = TextAnchor::start,
                        .ink = quietInk});
      return name == row.text;
    }
    case RowKind::legend:
    case RowKind::hidden:
      return setLegendRow(pages, row, middle, width);
    case RowKind::number: {
      setNumber(painter, row.number, middle);
      const Fitted text =
          fitted(row.text, middle + glm::vec2(numberWidth, 0.0f), width - numberWidth, rowText);
      setText(painter, text.text);
      return text.whole;
    }
    case RowKind::word: {
      const Fitted text = fitted(row.text, middle, width, rowText);
      setText(painter, text.text);
      return text.whole;
    }
    case RowKind::writeLine: {
      const glm::vec2 foot = at + glm::vec2(0.0f, height - 2.4f);
      setNumber(painter, row.number, foot - glm::vec2(0.0f, 0.5f * capHeightMm(rowText)));
      setRule(painter, foot + glm::vec2(numberWidth, 0.6f), width - numberWidth, 0.2f);
      break;
    }
  }
  return true;
}

}  // namespace sline::render
