// SPDX-License-Identifier: Apache-2.0
// Finds an order of a crowded column's boxes, and bends of their leaders, in which no leader is in
// another's way.
#pragma once

#include "render/labels/column.h"

namespace sline::render {

/// Bends leaders, and exchanges items as far as that alone does not help, until none crosses
/// another or passes its dot, or no exchange helps further. It begins with the order that they have
/// and, if that leaves some in others' way, with that of their places from the top, in which
/// leaders that run level before all others' boxes never cross (opo-leaders: Bekos, Kaufmann,
/// Symvonis and Wolff, as in column.h). Returns the places of the items.
std::vector<ColumnPlacement> untangled(const Column& column, std::vector<ColumnItem>& items);

}  // namespace sline::render
