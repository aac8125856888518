// SPDX-License-Identifier: Apache-2.0
// Adapts an order to its sheet.
#pragma once

#include "render/export/order/export_order.h"

namespace sline::render {

/// Returns the figure as the order's sheet has it: its page is fitted into the sheet, and labels
/// are shown as the sheet shows them. Where the sheet shows labels and the scene has none, they are
/// added to those structures that are seen, and of two that are each other's mirror image, left and
/// right, to that with more room beside it, numbered down the left side and then down the right.
/// Without a sheet it is unchanged.
ExportOrder sheetFigure(const ExportOrder& order);

}  // namespace sline::render
