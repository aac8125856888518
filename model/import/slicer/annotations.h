// SPDX-License-Identifier: Apache-2.0
// Reads points and rulers of a .mrml scene. Private to the reader.
#pragma once

#include "model/import/slicer/hierarchy.h"

namespace sline::model {

/// Appends the scene's fiducials: annotation nodes (Slicer 4.0 to 4.10), which hold their places,
/// and markups, which have their places in files beside the scene.
void readSlicerFiducials(const SlicerDocument& document, SlicerScene& result);

/// Tells whether the node and its first display node are visible.
bool slicerShows(const SlicerNodes& nodes, const XmlNode& node);

}  // namespace sline::model
