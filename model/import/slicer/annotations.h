// SPDX-License-Identifier: Apache-2.0
// Points and rulers of a .mrml scene. Private to the reader.
#pragma once

#include "model/import/slicer/hierarchy.h"

namespace sline::model {

/// Appends the scene's fiducials: annotation nodes (Slicer 4.0 to 4.10), which hold their places,
/// and markups, whose places lie in files beside the scene.
void readSlicerFiducials(const SlicerDocument& document, SlicerScene& result);

/// Whether the node and its first display node are visible.
bool slicerShows(const SlicerNodes& nodes, const XmlNode& node);

}  // namespace sline::model
