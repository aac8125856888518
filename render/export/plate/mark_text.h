// SPDX-License-Identifier: Apache-2.0
// Fits lines of marks into their room, and pictures above what is written at their foot.
#pragma once

#include <QString>
#include <span>
#include <vector>

#include "render/export/plate/marks.h"
#include "render/lettering/lettering.h"

namespace sline::render {

/// Returns the box of a text of one line, from the capitals' height to below the descenders.
LabelBox boxOf(const LetteringText& text);

/// Returns the line in that size, cut short where it is wider than that, millimetres.
QString elidedTo(const QString& line, float points, float width);

/// Lines at the very foot of a picture.
struct FootText {
  std::vector<QString> lines;
  float points = 0.0f;      ///< their size
  float lineHeight = 0.0f;  ///< millimetres
  bool shortened = false;   ///< the rest found no room
  /// Returns how far the last baseline is below the first.
  float below() const { return float(lines.size() - 1) * lineHeight; }
};
/// Returns the text in small lines of that width. Letters get smaller where it would take much of
/// the height; where it takes more than half of it even so, the rest is left out.
FootText footText(const QString& text, float labelPoints, const glm::vec2& size);

/// The width of a scale bar's pen, millimetres.
inline constexpr float scaleBarPen = 0.25f;
/// Returns the bar from that place to the right, with ticks upwards.
LetteringShape scaleBarShape(const glm::vec2& from, float length, const Colour& ink);

/// Returns the area without what lies below that height, millimetres.
SeenArea areaAbove(SeenArea area, float height);
/// Adds an item, `groundName`, below all others that puts ground in place of the drawing.
void addGround(Marks& marks, std::span<const LabelBox> boxes);

}  // namespace sline::render
