// SPDX-License-Identifier: Apache-2.0
// Tells which triangle lies across each edge, for walking over a surface.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "model/geometry/mesh.h"

namespace sline::model {

class FaceNeighbours {
 public:
  static constexpr std::uint32_t none = 0xffffffffu;

  explicit FaceNeighbours(const Mesh& mesh);
  /// Returns the triangle across the edge opposite to `corner` (0 … 2), or `none` at a border and
  /// where more than two triangles meet or the two disagree about which side is outside.
  std::uint32_t across(std::uint32_t triangle, int corner) const {
    return m_across[triangle][std::size_t(corner)];
  }

 private:
  std::vector<std::array<std::uint32_t, 3>> m_across;
};

}  // namespace sline::model
