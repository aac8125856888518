// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "model/camera/camera.h"
#include "model/focus/analysis.h"
#include "model/scene/scene.h"

namespace sline::model {

/// Returns the anatomical view from which most of the structures' surface is seen, half with
/// bones and organs before them and half with themselves alone; anterior where no other shows a
/// fifth more (METHOD §12.6).
AnatomicalView bestViewOf(const Scene& scene, std::span<const NodeId> structures);

/// Returns the unit vector towards an eye that sees most of the structures, with everything visible
/// before them, for a scene that has no sides of its own, such as a molecule. Among directions that
/// show nearly as much (nine tenths) it is the one that shows most of `besides`.
glm::vec3 clearestDirection(const Scene& scene, std::span<const NodeId> structures,
                            std::span<const NodeId> besides, FormIndex& forms);

}  // namespace sline::model
