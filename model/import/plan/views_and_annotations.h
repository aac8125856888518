// SPDX-License-Identifier: Apache-2.0
// Brings the data that sources hold beside surfaces into the scene that was built of these.
#pragma once

#include <optional>

#include "model/import/plan/folder_tree.h"

namespace sline::model {

/// Turns fiducials into annotations in space and saved views of 3D Slicer into saved views. `frame`
/// overrides the coordinate systems that files of fiducials name, as it does for surfaces; those of
/// a scene are where the scene has them.
Scene withViewsAndAnnotations(BuiltScene built, const Sources& sources, std::optional<Frame> frame);

}  // namespace sline::model
