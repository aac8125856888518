// SPDX-License-Identifier: Apache-2.0
// Places seeds of hatching where lattice lines pierce the surface (METHOD §6.2, §6.7). ▲ S projects
// along the normal onto the faces of a grid's cells; here lattice points are projected along the
// axis nearest to the face's normal, so a seed is a point of the surface, and lattices nest.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "model/geometry/surface.h"
#include "render/lines/hatching/surface_walk.h"

namespace sline::render {

/// Names a seed for as long as its mesh lives: a point of the lattice with cells of F_c·2^−level in
/// the plane across `axis`. The level is that of the coarsest lattice that has the point.
struct HatchSeed {
  int axis = 0;   ///< 0 … 2: the axis nearest to the surface's normal
  int level = 0;  ///< lattices of higher levels contain those of lower ones
  std::int32_t i = 0;
  std::int32_t j = 0;
  bool operator==(const HatchSeed&) const = default;
};

struct PlacedSeed {
  HatchSeed name;
  SurfacePoint at;
  glm::vec3 position{0.0f};
};

inline constexpr int coarsestHatchLevel = -8;
inline constexpr int finestHatchLevel = 24;

/// Returns the seeds of the lattice of `level` on those clusters within the box, which includes its
/// low sides and excludes its high ones, relative to the middle of the bounding sphere, the
/// lattices' origin. Strokes may take their place in the order of the seeds, which scatters them,
/// the coarsest first.
std::vector<PlacedSeed> hatchSeeds(const model::Surface& surface, int level, const model::Box& box,
                                   std::span<const std::uint32_t> clusters);

}  // namespace sline::render
