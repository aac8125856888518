// SPDX-License-Identifier: Apache-2.0
// What import does to a surface so that it can be drawn (METHOD §5): the steps of a label map are
// smoothed, what is too coarse is refined, the rest keeps every bit.
#pragma once

#include <span>
#include <vector>

#include "model/geometry/mesh.h"
#include "model/meshing/roughness.h"

namespace sline::model {

/// `automatic` smooths what shows the steps of a label map and refines what is too coarse to draw;
/// `off` leaves every vertex where the file has it; `steps` smooths everything that many times.
struct Smoothing {
  enum class Mode { automatic, off, steps } mode = Mode::automatic;
  int steps = 0;
  bool operator==(const Smoothing&) const = default;
};

/// What a surface says about itself before it is decided what to do with it.
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

/// The voxel grid behind each of the surfaces that came together (one folder, one scene): those cut
/// from one label map share its grid, and where several show it clearly, small ones that are too
/// small to show it themselves have it too. No spacing: none.
std::vector<VoxelGrid> commonGrids(std::span<const SurfaceMeasure> surfaces);

/// How many refinement steps each surface may have: the coarsest first, until the scene has 800,000
/// triangles, or 15 % more than it came with. METHOD §5 asks for edges of at most 2 % of F, which a
/// compact organ reaches with 70,000 triangles; given to each of a body's hundred structures that
/// would treble the scene for detail that no picture of it shows.
std::vector<int> refinementAllowances(std::span<const SurfaceMeasure> surfaces);

struct Smoothed {
  int smoothingSteps = 0;
  int refinementSteps = 0;
  float displacement = 0.0f;  ///< the farthest any of the file's vertices moved, in the mesh's unit
};

/// Smooths and refines in place as `smoothing` asks. Stepped surfaces move by less than half the
/// grid's step height. `grid` is this surface's own or common one.
Smoothed smooth(std::vector<glm::vec3>& positions, std::vector<Triangle>& triangles,
                const VoxelGrid& grid, const Smoothing& smoothing, int allowedRefinements = 2);

}  // namespace sline::model
