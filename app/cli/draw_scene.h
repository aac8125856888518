// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/cli/commands/command.h"
#include "app/cli/flags/picture_flags.h"

namespace sline::cli {

struct ArrangedScene {
  model::Scene scene;
  model::Camera camera;
  render::LooksInColour inColour;  ///< where the scene has black ink alone
};

/// Returns the scene as the order wants it drawn, with its camera. An error counts as wrong use.
Result<ArrangedScene> arrangeScene(const model::Scene& scene, const PictureSpec& spec);

/// Does the same as `arrangedFor` on a page of that size, with the order's labels made ready and
/// room left for them.
Result<ArrangedScene> arrangeOnPage(const glm::vec2& pageMm, const model::Scene& scene,
                                    PictureSpec& spec);

/// Draws the scene as ordered and writes the file; complains if it cannot.
Exit drawScene(const model::Scene& scene, const PictureSpec& spec, Progress& progress);

}  // namespace sline::cli
