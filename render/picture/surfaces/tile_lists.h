// SPDX-License-Identifier: Apache-2.0
// Finds which layers can show in which square of the picture: the CPU's share of the resolve
// (METHOD §10).
#pragma once

#include <span>
#include <vector>

#include "render/passes/resolve/resolve_pass.h"
#include "render/raster/tile_mask.h"

namespace sline::render {

struct ListedLayer {
  const TileMask* mask = nullptr;
  passes::ResolveLayer layer;  ///< with its area in pixels of the region
};

struct TileLists {
  std::vector<passes::ResolveTile> tiles;
  std::vector<passes::ResolveEntry> entries;
};

/// Returns the squares of `wanted`, which has a region's whole grid, including those without any
/// layer; in parts where the edge of a layer's area goes through a square. `layers` must be in
/// order of their ids, and all masks of the same grid.
TileLists tileLists(std::span<const ListedLayer> layers, const TileMask& wanted);

}  // namespace sline::render
