// SPDX-License-Identifier: Apache-2.0
// Represents a segmented volume: which structure each voxel belongs to, and where the voxels lie.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "model/base/units.h"
#include "model/import/source/raw_mesh.h"

namespace sline::model {

/// Describes one structure of a label volume.
struct Label {
  std::int64_t value = 0;  ///< its number in the file
  std::string name;        ///< empty where the file gives none
  std::optional<Colour> colour;
  std::vector<std::string> groups;  ///< enclosing groups, outermost first
};

/// Holds voxels of which each belongs to one structure or to none. Where a file's structures
/// overlap (segments in layers, DICOM SEG), each layer is a volume of its own: structures of one
/// volume share the faces at which they touch.
struct LabelVolume {
  glm::ivec3 size{0};
  std::vector<std::uint16_t> voxels;  ///< x fastest; 0: background, n: labels[n − 1]
  std::vector<Label> labels;          ///< fewer than 65,536; some may have no voxel
  glm::dmat4 toLps{1.0};  ///< indices (a voxel's centre at whole numbers) → mm, LPS; invertible
  /// The frame in which the file speaks, and the part of it that says so. Surfaces are handed on in
  /// it, so that overruling the header's frame overrules what the file means. Without a value
  /// nothing in the file tells; `toLps` then leads to coordinates in a frame that is still to be
  /// decided.
  std::optional<Frame> frame;
  std::string frameReason;
  bool onlySideOpen = false;  ///< as RawMesh::onlySideOpen; `toLps` then leads to (x, anterior,
                              ///< superior)
  std::string unitReason;     ///< evidence that its lengths are millimetres

  /// Returns where voxel (x, y, z) stands in `voxels`.
  std::size_t at(int x, int y, int z) const {
    return (std::size_t(z) * std::size_t(size.y) + std::size_t(y)) * std::size_t(size.x) +
           std::size_t(x);
  }
};

struct LabelVolumes {
  std::vector<LabelVolume> volumes;
  std::vector<ImportWarning> warnings;
};

}  // namespace sline::model
