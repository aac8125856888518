// SPDX-License-Identifier: Apache-2.0
// Reads the camera and the saved views of a .mrml scene. Private to the reader.
#pragma once

#include "model/import/slicer/hierarchy.h"

namespace sline::model {

/// Appends a view for each of the scene's own views, which are copies of the whole scene as it was,
/// and one for the scene's camera. Groups, models and fiducials must have been read.
void readSlicerViews(const SlicerDocument& document, SlicerScene& result);

}  // namespace sline::model
