// SPDX-License-Identifier: Apache-2.0
// Finds which layers can show in which square of the picture: the CPU's share of the resolve
// (METHOD §10).
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "render/passes/resolve/resolve_pass.h"

namespace sline::render {

/// Marks the squares of a region that a layer can touch.
class TileMask {
 public:
  TileMask() = default;
  /// Takes `region` in pixels of the whole picture; its squares start at its lower left corner.
  explicit TileMask(const PixelRect& region);

  void mark(const PixelRect& area);
  /// Also marks all squares of the other mask, which must have the same region.
  void mark(const TileMask& other);
  void markAll() { std::fill(m_marked.begin(), m_marked.end(), std::uint8_t(1)); }
  bool marked(int column, int row) const {
    return m_marked[std::size_t(row) * m_columns + column] != 0;
  }
  int columns() const { return m_columns; }
  int rows() const { return m_rows; }

 private:
  PixelRect m_region;
  int m_columns = 0;
  int m_rows = 0;
  std::vector<std::uint8_t> m_marked;
};

struct ListedLayer {
  const TileMask* mask = nullptr;
  passes::ResolveLayer layer;  ///< with its area in pixels of the region
};

struct TileLists {
  std::vector<passes::ResolveTile> tiles;
  std::vector<passes::ResolveEntry> entries;
};

/// Returns the squares of `wanted`, including those without any layer. `layers` must be in order of
/// their ids, and all masks of the same region.
TileLists tileLists(std::span<const ListedLayer> layers, const TileMask& wanted);

}  // namespace sline::render
