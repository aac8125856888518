// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "model/sculpting/implicit.h"

namespace sline::model {

/// Sets how a tube may lie.
struct CoilRules {
  float radius = 12.0f;  ///< mm; no two stretches of the tube come closer than twice that
  float spacing = 5.0f;  ///< mm between the points of its centre line
  Field keepOut;         ///< negative where the tube must not be
  int rounds = 40;       ///< in each stage
  int stages = 6;
  int settling = 2;      ///< the number of stages at the end in which it no longer grows
  float growth = 1.14f;  ///< growth factor of each other stage, while there is room
};

/// Lets a tube laid roughly along `path` settle like bowel in its cavity: it grows, bends gently,
/// pushes itself apart and gives way to its surroundings. The ends stay where they are.
std::vector<glm::vec3> settledCoil(std::span<const glm::vec3> path, const CoilRules& rules);

}  // namespace sline::model
