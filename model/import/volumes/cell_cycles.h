// SPDX-License-Identifier: Apache-2.0
// How the surface of one structure passes through a cell, the cube between eight voxel centres,
// told from which of them belong to the structure: the 256 cases of dual marching cubes (G. M.
// Nielson, "Dual Marching Cubes", IEEE Visualization 2004).
//
// Corners are numbered x + 2y + 4z. Edge 4a + b + 2c runs along axis a, b and c being the sides at
// which it lies along the next two axes (cyclic). Face 2a + s is that at side s of axis a.
#pragma once

#include <array>
#include <cstdint>

namespace sline::model {

class CellCycles {
 public:
  static constexpr std::uint8_t none = 0xff;
  /// The faces that a cycle of edges passes, turning counter-clockwise as seen from outside the
  /// structure.
  struct Ring {
    std::uint8_t count = 0;
    std::array<std::uint8_t, 12> faces{};
  };

  CellCycles();

  /// The edges that the surface crosses fall into cycles, each one sheet of surface in the cell: 0,
  /// 1, 2 or 3. `none` for an edge that is not crossed. Corners of the structure that lie
  /// diagonally in a face are parted there.
  std::uint8_t cycleOf(unsigned corners, unsigned edge) const { return m_cycleOf[corners][edge]; }
  /// Of the only cycle; count 0 where there are more or none.
  const Ring& ring(unsigned corners) const { return m_rings[corners]; }

  static constexpr unsigned edge(unsigned axis, unsigned b, unsigned c) {
    return 4 * axis + b + 2 * c;
  }
  /// The corner at which an edge begins.
  static constexpr unsigned edgeStart(unsigned edge) {
    const unsigned axis = edge / 4;
    return (edge & 1u) << (axis + 1) % 3 | (edge >> 1 & 1u) << (axis + 2) % 3;
  }
  /// The four corners of a face, in cyclic order.
  static std::array<unsigned, 4> faceCorners(unsigned face);
  /// True where just two corners of the face are the structure's, diagonally.
  static bool isDiagonal(unsigned corners, unsigned face);
  /// One of the two edges in the face that meet at its corner.
  static unsigned edgeInFace(unsigned face, unsigned corner);

 private:
  std::array<std::array<std::uint8_t, 12>, 256> m_cycleOf;
  std::array<Ring, 256> m_rings;
};

}  // namespace sline::model
