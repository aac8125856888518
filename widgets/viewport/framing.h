// SPDX-License-Identifier: Apache-2.0
// Computes cameras that show a scene or a part of it. `aspect` is the picture's width / height.
#pragma once

#include <span>

#include "model/scene/scene.h"

namespace sline::widgets {

/// Returns the bounds of what is visible at or below the nodes; empty where nothing is.
model::Box visibleBounds(const model::Scene& scene, std::span<const model::NodeId> ids);
/// Returns the camera, not turned, moved such that all that is visible at or below the nodes fits.
model::Camera fitted(const model::Camera& camera, const model::Scene& scene,
                     std::span<const model::NodeId> ids, float aspect);
/// Returns a camera that shows all that is visible, from that side.
model::Camera cameraFrom(const model::Scene& scene, model::AnatomicalView view, float aspect);
/// Returns the camera from which a scene is first seen: its view of that name, else the body from
/// the front.
model::Camera overview(const model::Scene& scene, float aspect);
/// Returns false where the whole scene is a speck, or so near that floats cannot tell one place
/// from another.
bool withinReach(const model::Camera& camera, const glm::vec3& pivot, const model::Scene& scene);

}  // namespace sline::widgets
