// SPDX-License-Identifier: Apache-2.0
// Prepares a surface on import so that it can be drawn (METHOD §5): the steps of a label map are
// smoothed, surfaces that are too coarse are refined, and all others keep every bit.
#pragma once

#include <span>
#include <vector>

#include "model/geometry/mesh.h"
#include "model/meshing/roughness.h"

namespace sline::model {

/// `automatic` smooths surfaces that show the steps of a label map and refines those that are too
/// coarse to draw; `off` leaves every vertex where the file has it; `steps` smooths everything that
/// many times.
struct Smoothing {
  enum class Mode { automatic, off, steps } mode = Mode::automatic;
  int steps = 0;
  bool operator==(const Smoothing&) const = default;
};

/// Holds the measurements of a surface from which its treatment is decided.
struct SurfaceMeasure {
  std::size_t vertices = 0;
  float meanEdge = 0.0f;
  VoxelGrid grid;
  bool greyValues = false;  ///< an isosurface of a smooth field: on a grid, but without steps
  std::size_t triangles = 0;
  float featureSize = 0.0f;  ///< F, radius of the bounding sphere
};
SurfaceMeasure measureSurface(std::span<const glm::vec3> positions,
                              std::span<const Triangle> triangles);

/// Returns the voxel grid behind each of the surfaces that came together (one folder, one scene):
/// surfaces cut from one label map share its grid, and where several show it clearly, those too
/// small to show it themselves get it too. No spacing means no grid.
std::vector<VoxelGrid> commonGrids(std::span<const SurfaceMeasure> surfaces);

/// Returns how many refinement steps each surface may have: the coarsest first, until the scene has
/// 800,000 triangles, or 15 % more than it came with. METHOD §5 asks for edges of at most 2 % of F,
/// which a compact organ reaches with 70,000 triangles; for each of a body's hundred structures
/// that would treble the scene for detail that no picture of it shows.
std::vector<int> refinementAllowances(std::span<const SurfaceMeasure> surfaces);

struct Smoothed {
  int smoothingSteps = 0;
  int refinementSteps = 0;
  float displacement =
      0.0f;  ///< the largest movement of any of the file's vertices, in the mesh's unit
};

/// Smooths and refines in place as `smoothing` says. Stepped surfaces move by less than half the
/// grid's step height. `grid` is this surface's own or common one.
Smoothed smooth(std::vector<glm::vec3>& positions, std::vector<Triangle>& triangles,
                const VoxelGrid& grid, const Smoothing& smoothing, int allowedRefinements = 2);

}  // namespace sline::model
