// SPDX-License-Identifier: Apache-2.0
// Makes the surfaces between all structures of a label volume as one net: one vertex in each cell
// (the cube between eight voxel centres) that more than one structure reaches, linked to those in
// the cells beside it with which it shares a face that the surface crosses. S. F. F. Gibson,
// "Constrained Elastic Surface Nets" (MICCAI 1998); for many labels S. F. Frisken, "SurfaceNets for
// Multi-Label Segmentations with Preservation of Sharp Boundaries" (JCGT 11(1), 2022).
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "model/import/volumes/formats/label_volume.h"

namespace sline::model {

/// Describes the part of a volume that holds structures, with a layer of background around it.
/// Voxel (x, y, z) of the box is voxel low + (x, y, z) − 1 of the volume.
class VoxelBox {
 public:
  /// The box is empty where the volume is nothing but background.
  explicit VoxelBox(const LabelVolume& volume);

  bool empty() const { return m_size.x == 0; }
  const glm::ivec3& low() const { return m_low; }
  /// Returns the cells along each axis: one more than voxels that are not of the layer around.
  glm::ivec3 cells() const { return m_size + 1; }
  std::uint16_t label(int x, int y, int z) const {
    const bool outside = x < 1 || y < 1 || z < 1 || x > m_size.x || y > m_size.y || z > m_size.z;
    return outside ? std::uint16_t(0) : *(row(y, z) + (x - 1));
  }
  /// Returns the labels of voxels (1 …, y, z), or null in the layer around.
  const std::uint16_t* row(int y, int z) const {
    if (y < 1 || z < 1 || y > m_size.y || z > m_size.z)
      return nullptr;
    return m_volume.voxels.data() + m_volume.at(m_low.x, m_low.y + y - 1, m_low.z + z - 1);
  }

 private:
  const LabelVolume& m_volume;
  glm::ivec3 m_low{0};
  glm::ivec3 m_size{0};
};

struct SurfaceNet {
  static constexpr std::uint32_t none = 0xffffffffu;
  struct Cell {
    std::uint16_t x = 0;  ///< between voxels x and x + 1 of the box
    std::uint16_t y = 0;
    std::uint16_t z = 0;
    /// Marks, where two labels meet, the corners that have the higher one, numbered x + 2y + 4z.
    std::uint8_t corners = 0;
    bool background = false;  ///< one of the labels is the background
    bool junction = false;    ///< three labels or more meet
  };
  std::vector<Cell> cells;  ///< z slowest, then y, then x
  /// Lists the cells beside each at −x, +x, −y, +y, −z, +z, or `none`.
  std::vector<std::array<std::uint32_t, 6>> neighbours;
};

/// Returns the net, or nothing where there are more cells than `mostCells` (at most 2^28) or
/// `goesOn` says no.
std::optional<SurfaceNet> surfaceNet(const VoxelBox& box, std::uint64_t mostCells,
                                     const std::function<bool()>& goesOn);

}  // namespace sline::model
