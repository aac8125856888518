// SPDX-License-Identifier: Apache-2.0
// Lets labels of a picture with black ink alone stand where they stand in the one with colours:
// they find their places by what one sees of each structure there.
#pragma once

#include "model/scene/scene.h"
#include "render/lettering/label_style.h"

namespace sline::render {

/// Returns how the scene's structures hide and show each other: their Γ, fills and opacities.
LooksInColour looksInColour(const model::Scene& scene);

/// Returns the scene with these looks, where there are any; structures that they do not mention
/// stay as they are.
model::Scene withLooksInColour(const model::Scene& scene, const LooksInColour& looks);

}  // namespace sline::render
