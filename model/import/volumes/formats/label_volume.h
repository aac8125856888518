// SPDX-License-Identifier: Apache-2.0
// A segmented volume: which structure each voxel belongs to, and where the voxels lie.
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

/// One structure of a label volume.
struct Label {
  std::int64_t value = 0;  ///< its number in the file
  std::string name;        ///< empty where nothing names it
  std::optional<Colour> colour;
  std::vector<std::string> groups;  ///< enclosing groups, outermost first
};

/// Every voxel belongs to one structure or to none. Where a file's structures overlap (segments in
/// layers, DICOM SEG), each layer is a volume of its own: structures of one volume share the faces
/// at which they touch.
struct LabelVolume {
  glm::ivec3 size{0};
  std::vector<std::uint16_t> voxels;  ///< x fastest; 0: background, n: labels[n − 1]
  std::vector<Label> labels;          ///< fewer than 65,536; some may have no voxel
  glm::dmat4 toLps{1.0};  ///< indices (a voxel's centre at whole numbers) → mm, LPS; invertible
  /// The frame in which the file speaks, and which part of it says so. Surfaces are handed on in
  /// it, so that who overrules the header's frame overrules what the file means. None: nothing in
  /// the file tells; `toLps` then leads to coordinates whose frame is still to be decided.
  std::optional<Frame> frame;
  std::string frameReason;
  bool onlySideOpen = false;  ///< as of RawMesh; `toLps` then leads to (x, anterior, superior)
  std::string unitReason;     ///< what makes its lengths millimetres

  /// Where voxel (x, y, z) stands in `voxels`.
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
