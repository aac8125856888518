// SPDX-License-Identifier: Apache-2.0
// Which layers can show in which square of the picture: the CPU's share of the resolve (METHOD
// §10).
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "render/passes/resolve/resolve_pass.h"

namespace sline::render {

/// The squares of a region that a layer can touch.
class TileMask {
 public:
  TileMask() = default;
  /// `region` in pixels of the whole picture; its squares start at its lower left corner.
  explicit TileMask(const PixelRect& region);

  void mark(const PixelRect& area);
  /// Also all squares of the other, which has the same region.
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
  passes::ResolveLayer layer;  ///< its area in pixels of the region
};

struct TileLists {
  std::vector<passes::ResolveTile> tiles;
  std::vector<passes::ResolveEntry> entries;
};

/// The squares of `wanted`, those without any layer too. `layers` in order of their ids; all masks
/// of the same region.
TileLists tileLists(std::span<const ListedLayer> layers, const TileMask& wanted);

}  // namespace sline::render
