// SPDX-License-Identifier: Apache-2.0
// Sets a page that says whose work the surfaces of a document's figures are.
#pragma once

#include "render/export/order/export_order.h"
#include "render/export/pdf/sheet_pages.h"

namespace sline::render {

/// Returns a paragraph for each of `sourceLines`, for paper.
std::string sourcesText(const model::Scene& scene);

/// Adds pages of the order's size with that text where the order wants such; none where the scene
/// says nothing.
void setSourcesPage(SheetPages& pages, const ExportOrder& order);

}  // namespace sline::render
