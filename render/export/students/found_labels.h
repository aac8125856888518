// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/export/order/export_order.h"

namespace sline::render {

/// Returns the page's scene with a label for each structure that the page ever shows, the large
/// ones first. Visible are those of what one sees as the page opens; each view shows those that are
/// seen in it.
model::Scene withFoundLabels(const ExportOrder& order);

/// Returns the scene with all of its labels shown wherever it is turned: the page itself leaves out
/// those of what one does not see.
model::Scene withAllLabels(const model::Scene& scene);

}  // namespace sline::render
