// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "model/scene/free_sides.h"
#include "model/scene/scene.h"

namespace sline::model {

struct VisibleStructure {
  const Node* node = nullptr;  ///< of the scene that was asked
  ResolvedStyle style;
};

/// Returns the structures that can be seen, in tree order, in one pass: those with triangles that
/// neither their own style nor a group's hides.
std::vector<VisibleStructure> visibleStructures(const Scene& scene);

/// Returns the points of them all that no section takes away, and those where sections cut edges;
/// LPS, millimetres.
std::vector<glm::vec3> visiblePoints(const Scene& scene);

/// Returns the camera, not turned, fitted to the visible points themselves: a slanted structure
/// leaves much of its box empty. As it was where nothing is visible.
Camera fittedToVisible(const Scene& scene, const Camera& camera, float aspect,
                       const FreeSides& sides = {});

}  // namespace sline::model
