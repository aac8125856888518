// SPDX-License-Identifier: Apache-2.0
// Puts a pocket in focus: its wall is shaded, what lies in it is drawn in full, all else is lines.
#pragma once

#include "model/camera/camera.h"
#include "model/edit/edited.h"
#include "model/pockets/scene_pockets.h"

namespace sline::model {

/// Returns the pocket's room as a closed surface.
MeshPtr pocketBody(const ProbeGrid& grid, const Pocket& pocket);

/// Draws the pocket's molecule as lines whose Γ rises to shading at the pocket's wall, the guests
/// in full and everything else as faint outlines. The pocket's room becomes a hidden structure in
/// the molecule's group "Pockets", from which Γ takes its distances; one of that name is replaced.
/// A molecule that is not in the scene any more, or a room that is null, changes nothing.
Edited withPocketInFocus(const Scene& scene, const ScenePockets& found, std::size_t index,
                         const MeshPtr& room);

/// Returns the camera that looks into the pocket through its mouth, as near as `from` would fit its
/// surroundings; `from` keeps its way of projection.
Camera viewIntoPocket(const ScenePocket& pocket, const Camera& from);

}  // namespace sline::model
