// SPDX-License-Identifier: Apache-2.0
// Splits a mask of voxels into its connected pieces.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "model/import/volumes/formats/label_volume.h"

namespace sline::model {

/// Groups voxels that are not 0, or those that are, into pieces of voxels that share a face. They
/// are held as runs along rows: memory is that of the mask's surface rather than of its volume.
class VoxelPieces {
 public:
  /// Returns the pieces, or nothing where `goesOn` says no, or where a third of all voxels or more
  /// begin runs of their own.
  static std::optional<VoxelPieces> find(const LabelVolume& mask, bool ofBackground,
                                         const std::function<bool()>& goesOn);

  /// Returns the number of voxels of each piece.
  const std::vector<std::uint64_t>& sizes() const { return m_sizes; }
  /// Turns the marked pieces into the other kind.
  void invert(LabelVolume& mask, const std::vector<bool>& pieces) const;

 private:
  struct Run {
    std::int32_t begin;
    std::int32_t end;
    std::uint32_t piece;
  };
  bool gather(const LabelVolume& mask, const std::function<bool()>& goesOn);
  void joinRows(std::size_t row, std::size_t other);
  std::uint32_t rootOf(std::uint32_t run);
  void number();

  bool m_background = false;
  std::vector<Run> m_runs;
  std::vector<std::size_t> m_firstRun;  ///< first run of each row (z slowest), and one more
  std::vector<std::uint64_t> m_sizes;
};

/// Fills the regions enclosed in each slice across the axis: all that do not reach the slice's
/// edge.
void fillSlices(LabelVolume& mask, int axis);

}  // namespace sline::model
