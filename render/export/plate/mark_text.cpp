// SPDX-License-Identifier: Apache-2.0
#include "render/export/plate/mark_text.h"

#include <QFontMetricsF>
#include <algorithm>
#include <array>
#include <utility>

#include "render/export/plate/marks.h"
#include "render/lettering/folded_text.h"
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

FootText footText(const QString& text, float labelPoints, const glm::vec2& size) {
  constexpr float leading = 1.3f;      // ems
  constexpr float usualShare = 0.25f;  // of the height
  constexpr float mostShare = 0.5f;
  FootText foot;
  for (const float share : {0.65f, 0.55f, 0.45f}) {
    foot.points = share * labelPoints;
    foot.lineHeight = leading * foot.points * millimetresPerPoint;
    foot.lines = foldedText(text, foot.points, size.x);
    if (float(foot.lines.size()) * foot.lineHeight <= usualShare * size.y)
      break;
  }
  const auto most = std::max<std::size_t>(1, std::size_t(mostShare * size.y / foot.lineHeight));
  foot.shortened = foot.lines.size() > most;
  if (foot.shortened) {
    foot.lines.resize(most);
    foot.lines.back() =
        elidedTo(foot.lines.back() + QStringLiteral(" \u2026"), foot.points, size.x);
  }
  return foot;
}

LetteringShape scaleBarShape(const glm::vec2& from, float length, const Colour& ink) {
  constexpr float tick = 1.3f;
  constexpr float halo = 0.35f;
  const glm::vec2 to = from + glm::vec2(length, 0.0f);
  const glm::vec2 up(0.0f, -tick);
  return {.path = polyline({from + up, from, to, to + up}),
          .pen = scaleBarPen,
          .ink = ink,
          .fill = {},
          .dashed = false,
          .halo = halo};
}

SeenArea areaAbove(SeenArea area, float height) {
  for (int y = 0; y < area.grid.rows; ++y)
    if (area.grid.middle(0, y).y > height)
      std::fill_n(area.cells.begin() + std::ptrdiff_t(y) * area.grid.columns, area.grid.columns,
                  false);
  return area;
}

void addGround(Marks& marks, std::span<const LabelBox> boxes) {
  const Colour ground = marks.lettering.ground;
  LetteringItem item{.name = std::string(groundName), .shapes = {}, .text = {}};
  for (const LabelBox& box : boxes)
    item.shapes.push_back({.path = roundedBox(box.low, box.high, 0.0f),
                           .pen = 0.0f,
                           .ink = ground,
                           .fill = ground,
                           .dashed = false,
                           .halo = 0.0f,
                           .ground = true});
  marks.lettering.items.insert(marks.lettering.items.begin(), std::move(item));
}

void cutOffAt(Marks& marks, const LabelBox& foot) {
  addGround(marks, std::array{foot});
  marks.boxes.push_back(foot);
  marks.cutOff = foot;
}

}  // namespace sline::render
