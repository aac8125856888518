// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/export/order/export_order.h"

namespace sline::render {

/// Draws the vectors and returns them as a document; `target` is the file that errors name.
Result<std::string> svgText(const ExportOrder& order, const std::filesystem::path& target,
                            const ExportProgress& progress);

/// Draws the vectors and writes them as an SVG document of the page's size.
Status writeSvg(const ExportOrder& order, const std::filesystem::path& target,
                const ExportProgress& progress);

/// Returns the bytes that the file takes, as it is made of the same text; 0 where it cannot be
/// made, or if `progress` stops it.
double svgWeight(const ExportOrder& order, const ExportProgress& progress);

}  // namespace sline::render
