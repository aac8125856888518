// SPDX-License-Identifier: Apache-2.0
#include "render/labels/column_heights.h"

#include "render/labels/span_sharing.h"

namespace sline::render {

std::vector<float> heightsInOrder(const std::vector<ColumnShare>& shares, const Span& room) {
  // The space below a box is part of its item.
  std::vector<ColumnItem> items;
  items.reserve(shares.size());
  for (const ColumnShare& one : shares)
    items.push_back({.box = {0.0f, one.share * (one.height + columnGap)},
                     .wanted = one.wanted + 0.5f * columnGap});
  Column column;
  column.gap = 0.0f;
  Settler settler;
  const std::vector<double>& tops = settler.tops(column, {room.low, room.high + columnGap}, items);
  std::vector<float> heights;
  heights.reserve(shares.size());
  for (std::size_t k = 0; k < shares.size(); ++k)
    heights.push_back(float(tops[k]) + 0.5f * (items[k].box.y - columnGap));
  return heights;
}

}  // namespace sline::render
