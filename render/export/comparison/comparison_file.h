// SPDX-License-Identifier: Apache-2.0
// Writes comparison sheets.
#pragma once

#include <filesystem>

#include "render/export/comparison/comparison_sheet.h"

namespace sline::render {

/// Tells whether a sheet can be written under that name: pdf, svg, png or tiff.
Status checkSheetName(const std::filesystem::path& target);

/// Writes the sheet as its name's ending says: SVG and PDF with lines as lines and text as text,
/// PNG with so many pixels to the inch. It needs a QGuiApplication.
Status writeSheet(const ComparisonSheet& sheet, const std::filesystem::path& target, float dpi);

}  // namespace sline::render
