// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "model/demo/implicit.h"

namespace sline::model {

/// A curved plate: a smooth surface through a net of points (Catmull and Rom both ways), thickened
/// on both sides by a half-thickness that changes smoothly between them; its border is rounded.
class Sheet {
 public:
  /// The net row by row, `columns` points to each row, at least two rows and two columns; a point's
  /// radius is half the plate's thickness there. Triangles have edges of about `step` mm.
  Sheet(std::span<const TubePoint> net, std::size_t columns, float step = 3.0f);

  /// Signed, in mm; farther than 12 mm from the bounds only a lower bound.
  float distance(const glm::vec3& p) const;
  const Box& bounds() const { return m_bounds; }

 private:
  /// A few neighbouring triangles and a sphere that holds them with their thickness.
  struct Patch {
    Sphere sphere;
    std::vector<std::array<std::uint32_t, 3>> triangles;
  };
  void addPatches(std::size_t rows, std::size_t columns);
  float distanceTo(const Patch& patch, const glm::vec3& p) const;

  std::vector<TubePoint> m_points;
  std::vector<Patch> m_patches;
  Box m_bounds;
};

}  // namespace sline::model
