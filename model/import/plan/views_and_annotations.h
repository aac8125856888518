// SPDX-License-Identifier: Apache-2.0
// What sources hold beside surfaces, brought into the scene that was built of these.
#pragma once

#include <optional>

#include "model/import/plan/folder_tree.h"

namespace sline::model {

/// Fiducials become annotations in space, saved views of 3D Slicer become saved views. `frame`
/// overrides what files of fiducials say of their coordinates, as it does for surfaces; those of a
/// scene are where the scene has them.
Scene withViewsAndAnnotations(BuiltScene built, const Sources& sources, std::optional<Frame> frame);

}  // namespace sline::model
