// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/export/order/export_order.h"

namespace sline::render {

/// Returns the page's scene with labels on structures that one sees as it opens or in its views,
/// the large ones first, where it has no annotations. Each view shows those that are seen in it.
model::Scene withFoundLabels(const ExportOrder& order);

}  // namespace sline::render
