// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/cli/command.h"
#include "app/cli/flags/picture_flags.h"

namespace sline::cli {

struct ArrangedScene {
  model::Scene scene;
  model::Camera camera;
};

/// The scene as the order wants it drawn, and from where. An error is a wrong use.
Result<ArrangedScene> arrangedFor(const model::Scene& scene, const PictureOrder& order);

/// The same on a page of that size, with the order's labels made ready and room left for them.
Result<ArrangedScene> arrangedOn(const glm::vec2& pageMm, const model::Scene& scene,
                                 PictureOrder& order);

/// Draws the scene as ordered and writes the file; complains where it cannot.
Exit drawScene(const model::Scene& scene, const PictureOrder& order, Progress& progress);

}  // namespace sline::cli
