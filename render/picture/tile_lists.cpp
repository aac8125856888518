// SPDX-License-Identifier: Apache-2.0
#include "render/picture/tile_lists.h"

#include <algorithm>
#include <cassert>

namespace sline::render {

namespace {
constexpr int side = passes::ResolvePass::tileSide;
}  // namespace

TileMask::TileMask(const PixelRect& region)
    : m_region(region),
      m_columns((region.width + side - 1) / side),
      m_rows((region.height + side - 1) / side),
      m_marked(std::size_t(m_columns) * m_rows, 0) {}

void TileMask::mark(const PixelRect& area) {
  const PixelRect seen = intersection(area, m_region);
  if (seen.empty())
    return;
  const int left = (seen.x - m_region.x) / side;
  const int right = (seen.right() - 1 - m_region.x) / side;
  const int bottom = (seen.y - m_region.y) / side;
  const int top = (seen.top() - 1 - m_region.y) / side;
  for (int row = bottom; row <= top; ++row)
    std::fill_n(m_marked.begin() + std::ptrdiff_t(row) * m_columns + left, right - left + 1,
                std::uint8_t(1));
}

void TileMask::mark(const TileMask& other) {
  assert(other.m_marked.size() == m_marked.size());
  for (std::size_t i = 0; i < m_marked.size(); ++i)
    m_marked[i] |= other.m_marked[i];
}

TileLists tileLists(std::span<const ListedLayer> layers, const TileMask& wanted) {
  TileLists lists;
  std::vector<passes::ResolveEntry> packed;
  packed.reserve(layers.size());
  for (const ListedLayer& layer : layers)
    packed.push_back(passes::resolveEntry(layer.layer));
  for (int row = 0; row < wanted.rows(); ++row)
    for (int column = 0; column < wanted.columns(); ++column) {
      if (!wanted.marked(column, row))
        continue;
      passes::ResolveTile tile{column * side, row * side, std::int32_t(lists.entries.size()), 0};
      for (std::size_t i = 0; i < layers.size(); ++i)
        if (layers[i].mask->marked(column, row))
          lists.entries.push_back(packed[i]);
      tile.count = std::int32_t(lists.entries.size()) - tile.first;
      lists.tiles.push_back(tile);
    }
  return lists;
}

}  // namespace sline::render
