// SPDX-License-Identifier: Apache-2.0
// A sheet of paper for teaching, for patients or for print: figure, title, legend, labels.
#pragma once

#include <QByteArray>

#include "render/export/order/export_order.h"

namespace sline::render {

/// The whole PDF file. A scene without labels of its own has its structures labelled where the
/// sheet needs labels. `progress` may stop it; then the error is `givenUp`'s for `target`.
Result<QByteArray> sheetDocument(const ExportOrder& order, const std::filesystem::path& target,
                                 const ExportProgress& progress);

/// The figure alone, on a page of its size.
Result<QByteArray> figureDocument(const ExportOrder& order, const std::filesystem::path& target,
                                  const ExportProgress& progress);

}  // namespace sline::render
