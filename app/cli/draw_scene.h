// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/cli/command.h"
#include "app/cli/picture_flags.h"

namespace sline::cli {

/// Styles the scene, places the camera, draws and writes as ordered; complains about what is wrong.
Exit drawScene(const model::Scene& scene, const PictureOrder& order, Progress& progress);

}  // namespace sline::cli
