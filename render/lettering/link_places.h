// SPDX-License-Identifier: Apache-2.0
// Finds where the links of texts lie once these are set, for whoever can click on them.
#pragma once

#include <string>
#include <vector>

#include "render/lettering/label_painter.h"

namespace sline::render {

/// Holds the part of a link's words that stands in one line.
struct LinkPlace {
  LabelBox box;           ///< around its letters; millimetres of the output
  float baseline = 0.0f;  ///< of the line, from the upper edge
  model::MarkupLink link;
};

/// Returns where links of the marked-up text lie, line by line, in the lines that were set of it.
/// Words that found no room are nowhere.
std::vector<LinkPlace> linkPlaces(const std::string& markup, const LetteringText& text);
/// Returns where links of callouts lie; none of labels that are numbers or blank.
std::vector<LinkPlace> linkPlaces(const LabelPlate& plate);

}  // namespace sline::render
