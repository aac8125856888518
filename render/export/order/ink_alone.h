// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/export/order/export_order.h"

namespace sline::render {

/// Leaves the order's scene black ink alone (`model::withInkAlone`), with the labels in the places
/// that they have in colour.
void leaveInkAlone(ExportOrder& order);

}  // namespace sline::render
