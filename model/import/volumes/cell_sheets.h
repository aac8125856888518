// SPDX-License-Identifier: Apache-2.0
// Determines how the surface of one structure passes through a cell, the cube between eight voxel
// centres, from which of them belong to the structure (G. M. Nielson, "Dual Marching Cubes", IEEE
// Visualization 2004).
//
// Corners are numbered x + 2y + 4z. Edge 4a + b + 2c runs along axis a, b and c being the sides at
// which it lies along the next two axes (cyclic). Face 2a + s is that at side s of axis a.
#pragma once

#include <array>
#include <cstdint>

namespace sline::model {

/// Holds the cycles into which the edges that the surface crosses fall; each is one sheet of
/// surface in the cell.
struct CellSheets {
  static constexpr std::uint8_t none = 0xff;
  std::array<std::uint8_t, 12> ofEdge;  ///< 0 … 3, or `none` for an edge that is not crossed
  std::uint8_t count = 0;
};

/// Returns the sheets of a cell. Corners of the structure that lie diagonally in a face are parted
/// there, unless its bit is set in `joinedFaces`: then the two other corners are parted.
CellSheets cellSheets(unsigned corners, unsigned joinedFaces);

/// Holds all 256 cases with every diagonal parted.
class CellSheetTable {
 public:
  CellSheetTable();
  const CellSheets& operator[](unsigned corners) const { return m_sheets[corners]; }

 private:
  std::array<CellSheets, 256> m_sheets;
};

constexpr unsigned cellEdge(unsigned axis, unsigned b, unsigned c) {
  return 4 * axis + b + 2 * c;
}
/// Returns the corner at which an edge begins.
constexpr unsigned edgeStart(unsigned edge) {
  const unsigned axis = edge / 4;
  return (edge & 1u) << (axis + 1) % 3 | (edge >> 1 & 1u) << (axis + 2) % 3;
}
/// Returns the four corners of a face, in cyclic order.
std::array<unsigned, 4> faceCorners(unsigned face);
/// Returns true where just two corners of the face belong to the structure, diagonally.
bool isDiagonal(unsigned corners, unsigned face);

}  // namespace sline::model
