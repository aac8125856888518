// SPDX-License-Identifier: Apache-2.0
// Takes the steps of the voxels out of a surface net without taking its structures' volume.
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <vector>

#include "model/import/volumes/label_sheets.h"
#include "model/import/volumes/surface_net.h"

namespace sline::model {

struct Relaxation {
  int steps = 60;         ///< in which a vertex stays in its cell
  int looseSteps = 20;    ///< in which it may go as far as the centres of the cells beside it
  float momentum = 0.8f;  ///< in [0, 1): how much of the last step is taken again in the former
  std::vector<glm::vec3> from = {};  ///< where each point is at first; empty: amid its cell
};

/// Where each point comes to lie: (x, y, z) of its cell − ½, times `spacing`, moved by less
/// than half of `spacing` along each axis, or with loose steps by less than all of it. Empty where
/// `goesOn` says no.
///
/// Gibson lets each vertex move towards the mean of its neighbours within its cell, where it keeps
/// to every voxel's word. That also shrinks what is round, a vessel as wide as a voxel to nothing.
/// Here a vertex moves along its normal only by what the surface is more curved than around it, as
/// in surface diffusion (W. W. Mullins, J. Appl. Phys. 28, 1957), which keeps volume: spheres and
/// tubes stay, steps go. Curvature is that of a structure's whole surface, whatever it touches
/// where; at points of several structures the mean of what each of them wants is taken. What is
/// drawn slice by slice also jumps by more than a voxel from one slice to the next: the loose steps
/// take such short waves away.
std::vector<glm::vec3> relaxed(const SurfaceNet& net, const LabelSheets& sheets,
                               const glm::vec3& spacing, const Relaxation& relaxation,
                               const std::function<bool()>& goesOn);

}  // namespace sline::model
