// SPDX-License-Identifier: Apache-2.0
// Fits lines of marks into their room, and pictures above what is written at their foot.
#pragma once

#include <QString>
#include <vector>

#include "render/labels/seen_map.h"
#include "render/lettering/lettering.h"

namespace sline::render {

/// Returns the box of a text of one line, from the capitals' height to below the descenders.
LabelBox boxOf(const LetteringText& text);

/// Returns the line in that size, cut short where it is wider than that, millimetres.
QString elidedTo(const QString& line, float points, float width);

/// Returns the text in lines of that width, at most so many; the last is cut where more is to be
/// said.
std::vector<QString> foldedTo(const QString& text, float points, float width, std::size_t most);

/// Returns the area without what lies below that height, millimetres.
SeenArea areaAbove(SeenArea area, float height);

}  // namespace sline::render
