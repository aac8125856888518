// SPDX-License-Identifier: Apache-2.0
// Computes cameras that show a scene or a part of it. `aspect` is the picture's width / height.
#pragma once

#include <optional>
#include <span>

#include "model/camera/free_sides.h"
#include "model/scene/scene.h"

namespace sline::model {

/// Returns the bounds of what is visible at or below the nodes; empty where nothing is.
Box visibleBounds(const Scene& scene, std::span<const NodeId> ids);
/// Returns the scene's own view from which it is first seen, if there is one.
std::optional<Camera> savedOverview(const Scene& scene);
/// Returns the camera of a view saved for pictures of 4:3, opened (up to 75°, and moved back
/// beyond that) where the sides leave less width to the anatomy than it has there.
Camera withSides(const Camera& saved, float aspect, const FreeSides& sides);

}  // namespace sline::model
