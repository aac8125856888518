// SPDX-License-Identifier: Apache-2.0
// Says how large a structure is by what was read of it, before import smoothed or decimated it.
#pragma once

#include "model/geometry/extent.h"
#include "model/scene/scene.h"

namespace sline::model {

struct MeasuredExtent {
  Extent extent;
  bool areaAsRead = true;    ///< false: measured on a surface that import has changed
  bool volumeAsRead = true;  ///< in the same way
};

/// Tells whether the surface is the one that was read: import neither smoothed, refined nor
/// decimated it.
bool isAsRead(const Provenance& provenance);
/// Returns how far import has moved the surface at most, in mm; 0 where it is the one that was
/// read.
float movedMm(const Provenance& provenance);

/// Measures the structure: what was measured while it was read takes precedence. Takes long on a
/// large mesh.
MeasuredExtent measuredExtent(const Node& structure);

}  // namespace sline::model
