// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "model/scene/scene.h"

namespace sline::cli {

/// Returns the scene's first view, else its front, as a small square PNG for its scene file. Empty,
/// with a warning, if there is no OpenGL to draw it with.
std::string thumbnailOf(const model::Scene& scene);

}  // namespace sline::cli
