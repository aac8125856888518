// SPDX-License-Identifier: Apache-2.0
// Declares what can be chosen about a figure's file beside what the figure itself says: the command
// line and the window make their flags and fields of these.
#pragma once

#include "render/export/order/export_option.h"
#include "render/export/page/drawn_page.h"

namespace sline::render {

/// Returns the resolution, the depth, and who made it, what it shows and whose work it is of.
OptionList figureOptions();

/// Returns an order with these options as usual; nothing else in it is used.
ExportOrder usualFigureOrder();

/// Returns how the pixels of a figure's files are; `blackAndWhite` is what the figure says.
PagePixels pixelsOf(const ExportOrder& order, bool blackAndWhite);

/// Tells whether the page looks the same with both, and may be written with both or neither.
bool samePage(const ExportOrder& one, const ExportOrder& other);

/// Fails where the options do not go with the figure.
Status checkFigureOptions(const ExportOrder& order, bool blackAndWhite);

}  // namespace sline::render
