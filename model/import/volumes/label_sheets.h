// SPDX-License-Identifier: Apache-2.0
// Splits a surface net into the closed surfaces of its structures, which keep sharing the points at
// which they touch.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "model/import/volumes/surface_net.h"

namespace sline::model {

/// Holds points and nodes. A point is a place: the one of a cell, or one for each sheet where two
/// structures meet in several sheets in it. A node is one structure's vertex at a point; around
/// each node the structure's faces form one fan. Where structures or parts of one meet at
/// diagonally neighbouring voxels, those of the higher label are parted.
struct LabelSheets {
  /// Describes a face across the edge between two voxels, counter-clockwise seen from outside the
  /// structure.
  struct Quad {
    std::array<std::uint32_t, 4> nodes;
    /// Encodes the cell at its far end × 8, the axis of the voxel edge × 2, and whether the
    /// structure lies at that edge's end rather than at its beginning.
    std::uint32_t face;
  };
  /// Holds the nodes after and before a node in one of its quads.
  struct Side {
    std::uint32_t next;
    std::uint32_t last;
  };

  std::vector<std::uint32_t> cellOf;   ///< cell of each point
  std::vector<std::uint32_t> pointOf;  ///< point of each node
  std::vector<Quad> quads;             ///< by label
  std::vector<std::size_t> firstQuad;  ///< label n has those from firstQuad[n − 1] to firstQuad[n]
  std::vector<std::uint32_t> firstSide;  ///< start of each node's sides in `sides`, and one more
  std::vector<Side> sides;

  std::span<const Quad> quadsOf(std::size_t label) const {
    return {quads.data() + firstQuad[label - 1], quads.data() + firstQuad[label]};
  }
  std::span<const Side> sidesOf(std::size_t node) const {
    return {sides.data() + firstSide[node], sides.data() + firstSide[node + 1]};
  }
};

/// Returns the sheets; `labels` is the highest label there is. Where there are more than
/// `mostQuads` quads, none are made.
LabelSheets labelSheets(const VoxelBox& box, const SurfaceNet& net, std::size_t labels,
                        std::uint64_t mostQuads);

}  // namespace sline::model
