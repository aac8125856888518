// SPDX-License-Identifier: Apache-2.0
// Removes the steps of the voxels from a surface net and keeps the volume of its structures.
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <vector>

#include "model/import/volumes/label_sheets.h"
#include "model/import/volumes/surface_net.h"

namespace sline::model {

struct Relaxation {
  int steps = 60;         ///< steps in which a vertex stays in its cell
  int looseSteps = 20;    ///< steps in which it may go as far as the centres of the cells beside it
  float momentum = 0.8f;  ///< in [0, 1): share of the last step that is taken again, in `steps`
                          ///< alone
  std::vector<glm::vec3> from = {};  ///< initial place of each point; empty: amid its cell
};

/// Returns where each point comes to lie: (x, y, z) of its cell − ½, times `spacing`, moved by less
/// than half of `spacing` along each axis, or with loose steps by less than all of it. The result
/// is empty where `goesOn` says no.
///
/// Gibson lets each vertex move towards the mean of its neighbours within its cell, where it agrees
/// with every voxel. That also shrinks round shapes, a vessel as wide as a voxel to nothing. Here a
/// vertex moves along its normal only by the amount by which the surface is more curved than around
/// it, as in surface diffusion (W. W. Mullins, J. Appl. Phys. 28, 1957), which keeps volume:
/// spheres and tubes stay, steps go. Curvature is that of a structure's whole surface, whatever it
/// touches and where; at points of several structures the mean of their displacements is taken.
/// Structures drawn slice by slice also jump by more than a voxel from one slice to the next: the
/// loose steps take such short waves away.
std::vector<glm::vec3> relaxed(const SurfaceNet& net, const LabelSheets& sheets,
                               const glm::vec3& spacing, const Relaxation& relaxation,
                               const std::function<bool()>& goesOn);

}  // namespace sline::model
