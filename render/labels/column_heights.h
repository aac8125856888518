// SPDX-License-Identifier: Apache-2.0
// Stacks the boxes of a column whose order is known.
#pragma once

#include <vector>

#include "render/labels/column.h"

namespace sline::render {

struct ColumnShare {
  float wanted = 0.0f;  ///< height of the box's middle
  float height = 0.0f;  ///< of the box
  float share = 1.0f;   ///< of its room that it takes; less where it comes or goes
};

/// Returns the middles of boxes from the top down, as near what they want as the others allow. They
/// change no faster than what is wanted, and steadily with the shares. They must fit.
std::vector<float> heightsInOrder(const std::vector<ColumnShare>& shares, const Span& room);

}  // namespace sline::render
