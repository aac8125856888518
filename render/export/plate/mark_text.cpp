// SPDX-License-Identifier: Apache-2.0
#include "render/export/plate/mark_text.h"

#include <QFontMetricsF>
#include <algorithm>
#include <utility>

#include "render/export/plate/marks.h"
#include "render/lettering/label_texts.h"

namespace sline::render {

LabelBox boxOf(const LetteringText& text) {
  const float em = text.points * millimetresPerPoint;
  const float width = textWidthMm(text.lines.front(), text.points);
  const float left = text.at.x - (text.anchor == TextAnchor::end      ? width
                                  : text.anchor == TextAnchor::middle ? 0.5f * width
                                                                      : 0.0f);
  return {{left, text.at.y - capHeightMm(text.points)}, {left + width, text.at.y + 0.22f * em}};
}

QString elidedTo(const QString& line, float points, float width) {
  const qreal scale = qreal(points * millimetresPerPoint) / labelFontPixels;
  return QFontMetricsF(labelFont()).elidedText(line, Qt::ElideRight, qreal(width) / scale);
}

std::vector<QString> foldedTo(const QString& text, float points, float width, std::size_t most) {
  std::vector<QString> lines{{}};
  for (const QString& word : text.split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
    QString& last = lines.back();
    const QString longer = last.isEmpty() ? word : last + QLatin1Char(' ') + word;
    if (last.isEmpty() || lines.size() == most || textWidthMm(longer, points) <= width)
      last = longer;
    else
      lines.push_back(word);
  }
  for (QString& line : lines)
    line = elidedTo(line, points, width);
  return lines;
}

SeenArea areaAbove(SeenArea area, float height) {
  for (int y = 0; y < area.grid.rows; ++y)
    if (area.grid.middle(0, y).y > height)
      std::fill_n(area.cells.begin() + std::ptrdiff_t(y) * area.grid.columns, area.grid.columns,
                  false);
  return area;
}

void cutOffAt(Marks& marks, const LabelBox& foot) {
  const Colour ground = marks.lettering.ground;
  LetteringItem item{.name = std::string(groundName), .shapes = {}, .text = {}};
  item.shapes.push_back({.path = roundedBox(foot.low, foot.high, 0.0f),
                         .pen = 0.0f,
                         .ink = ground,
                         .fill = ground,
                         .dashed = false,
                         .halo = 0.0f});
  marks.lettering.items.insert(marks.lettering.items.begin(), std::move(item));
  marks.boxes.push_back(foot);
  marks.cutOff = foot;
}

}  // namespace sline::render
