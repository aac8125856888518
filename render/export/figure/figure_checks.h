// SPDX-License-Identifier: Apache-2.0
// Checks a figure against what can be printed: letters that can be read and lines that stay.
#pragma once

#include <vector>

#include "render/export/figure/figure_page.h"

namespace sline::render {

/// Returns what is smaller than the figure allows, at most one thing of a kind for each panel: the
/// smallest text by its words, and the thinnest kind of line by its structure. The errors' `where`
/// is the panel.
std::vector<Error> printFaults(const ComposedFigure& figure);

}  // namespace sline::render
