// SPDX-License-Identifier: Apache-2.0
// Makes the paper that lines of a pencil show, for drawings in which it is no shape but a mask.
#pragma once

#include "render/raster/image.h"

namespace sline::render {

/// A square of paper that covers a page when it is laid side by side. At its edges one grain stands
/// beside another, as everywhere on it.
struct PaperTile {
  Image image;  ///< grey, opaque: the share of ink that is taken, 255: all
  float sideMm = 1.0f;
};

/// Returns the paper of a page, on which lines have that grain, in steps of a hundredth.
PaperTile paperTile(int percent, float pageHeightMm);
/// Returns the step in which a structure's grain is drawn; 0: its lines are of a pen.
int paperPercent(float grain);

}  // namespace sline::render
