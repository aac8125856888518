// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/export/order/export_order.h"

namespace sline::render {

/// Writes the figure or the sheet as PDF: lines are lines, and text is text, in fonts that are
/// embedded in the file.
Status writePdf(const ExportOrder& order, const std::filesystem::path& target,
                const ExportProgress& progress);

/// Returns the bytes that the file takes, as the same document is made; 0 where it cannot be made,
/// or if `progress` stops it.
double pdfWeight(const ExportOrder& order, const ExportProgress& progress);

}  // namespace sline::render
