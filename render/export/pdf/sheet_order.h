// SPDX-License-Identifier: Apache-2.0
// What a sheet makes of an order.
#pragma once

#include "render/export/order/export_order.h"

namespace sline::render {

/// In the language (a BCP 47 tag), where the name is known in it.
std::string structureName(const std::string& name, const std::string& language);

/// The figure as the order's sheet has it: its page fitted into the sheet, labels shown as the
/// sheet shows them, and where it shows some and the scene has none that is visible, a label for
/// each structure that is seen. Unchanged without a sheet.
ExportOrder sheetFigure(const ExportOrder& order);

}  // namespace sline::render
