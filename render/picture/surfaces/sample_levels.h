// SPDX-License-Identifier: Apache-2.0
// Keeps coarser forms of a surface for moving pictures, in which a sample of it stands for several
// pixels. They have some of the surface's own vertices, so that shading is as smooth as ever; lines
// are always those of the surface itself.
#pragma once

#include <memory>
#include <vector>

#include "model/geometry/surface.h"
#include "render/picture/surfaces/detail_levels.h"

namespace sline::render {

/// The forms of one surface, each of about a quarter of the triangles of the one before.
class SampleLevels {
 public:
  /// Surfaces of fewer triangles have none: little could be won.
  static constexpr std::size_t leastTriangles = 2'000;

  /// Returns the coarsest form allowed; null: that is the surface itself. What is not there yet is
  /// made, which takes half a second per million triangles on one core, but in a hurry. The
  /// surface has to be the same each time.
  const model::Clusters* at(const model::Surface& surface, const Coarseness& allowed);

 private:
  struct Level {
    model::Clusters clusters;  ///< only what drawing needs
    float edge = 0.0f;         ///< mean, mm
  };

  /// Appends the next level, or finds that there is none.
  void add(const model::Surface& surface);

  std::vector<std::unique_ptr<Level>> m_levels;
  bool m_complete = false;  ///< there is no coarser one
};

}  // namespace sline::render
