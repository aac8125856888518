// SPDX-License-Identifier: Apache-2.0
// Detects whether a surface comes from a label map, whose steps it would then show. Its vertices
// tell (METHOD §5: "whether the steps repeat along one axis"): even after smoothing and decimation
// they repeat along the axes with the spacing of the voxels, which is also the height of the steps.
#pragma once

#include <algorithm>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "model/geometry/mesh.h"

namespace sline::model {

/// Describes the voxel grid behind a surface: its spacing along x, y and z, 0 where none shows.
struct VoxelGrid {
  glm::vec3 spacing{0.0f};
  /// The power of the period among the vertices' coordinates, in units of the power that vertices
  /// without any order would show (whose largest is about the logarithm of the number of periods
  /// tried).
  glm::vec3 power{0.0f};

  /// Returns the largest spacing: the distance between slices.
  float coarsest() const { return std::max({spacing.x, spacing.y, spacing.z}); }
  bool found() const { return spacing.x > 0.0f || spacing.y > 0.0f || spacing.z > 0.0f; }
  /// Returns the height of a step on a face with that normal: the grid's spacing across the
  /// surface.
  float stepHeight(const glm::vec3& normal) const;
};

VoxelGrid findVoxelGrid(std::span<const glm::vec3> positions, float meanEdge);

/// Tells whether the surface is an isosurface of a smooth field by marching cubes: two coordinates
/// of each vertex lie on the grid, the third anywhere between. Such a surface lies on a grid but
/// has no steps.
bool isGreyValueSurface(std::span<const glm::vec3> positions, const VoxelGrid& grid);

}  // namespace sline::model
