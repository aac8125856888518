// SPDX-License-Identifier: Apache-2.0
// Makes a sheet of paper for teaching, for patients or for print: figure, title, legend, labels.
#pragma once

#include <QByteArray>

#include "render/export/order/export_order.h"

namespace sline::render {

/// Returns the whole PDF file. If the scene has no labels of its own and the sheet needs labels,
/// its structures are labelled. `progress` may stop it; the error is then `givenUp`'s for `target`.
Result<QByteArray> sheetDocument(const ExportOrder& order, const std::filesystem::path& target,
                                 const ExportProgress& progress);

/// Returns the figure alone, on a page of its size.
Result<QByteArray> figureDocument(const ExportOrder& order, const std::filesystem::path& target,
                                  const ExportProgress& progress);

}  // namespace sline::render
