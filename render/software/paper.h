// SPDX-License-Identifier: Apache-2.0
// Leaves the hollows of a rough paper without ink, as grain.glsl does.
#pragma once

#include <glm/vec2.hpp>

namespace sline::render {

/// Returns the share of ink that stays at the pixel. `grain` holds how much the paper takes, 0 … 1,
/// and the size of its grain in px.
float paperAt(const glm::vec2& pixel, const glm::vec2& grain);

}  // namespace sline::render
