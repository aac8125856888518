// SPDX-License-Identifier: Apache-2.0
// Keeps the focus in sight while the camera goes round it.
#pragma once

#include <span>

#include "model/camera/camera.h"
#include "model/scene/scene.h"

namespace sline::model {

/// Returns the scene with what hides its focus from any of the cameras drawn as a picture draws
/// what hides it from one: open, so that the focus is seen from all of them, and alike in all of
/// them. Structures that are locked, hidden or were set by hand stay as they are, and so does a
/// scene without a focus.
Scene withFocusSeenFrom(const Scene& scene, std::span<const Camera> cameras);

}  // namespace sline::model
