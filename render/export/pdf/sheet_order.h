// SPDX-License-Identifier: Apache-2.0
// What a sheet makes of an order.
#pragma once

#include "render/export/order/export_order.h"

namespace sline::render {

/// In the language (a BCP 47 tag), where the name is known in it.
std::string structureName(const std::string& name, const std::string& language);

/// A visible annotation. A scene without one has its structures labelled where a sheet shows
/// labels: those that are seen, of a left and a right one that with more room beside it.
bool hasLabels(const model::Scene& scene);

/// The figure as the order's sheet has it: its page fitted into the sheet, labels shown as the
/// sheet shows them, and added where it shows some and the scene has none: numbered down the left
/// side and then down the right. Unchanged without a sheet.
ExportOrder sheetFigure(const ExportOrder& order);

}  // namespace sline::render
