// SPDX-License-Identifier: Apache-2.0
// Brings the data that sources hold beside surfaces into the scene that was built of these.
#pragma once

#include "model/import/plan/folder_tree.h"

namespace sline::model {

struct FurnishedScene {
  Scene scene;
  std::size_t namesCut = 0;  ///< texts and names of views from which words were left out
};

/// Turns fiducials into annotations in space and saved views of 3D Slicer into saved views. The
/// options' frame overrides the coordinate systems that files of fiducials name, as it does for
/// surfaces; those of a scene are where the scene has them. Of their words those are left out that
/// may be a person's name, unless the options keep names.
FurnishedScene withViewsAndAnnotations(BuiltScene built, const Sources& sources,
                                       const ImportOptions& options);

}  // namespace sline::model
