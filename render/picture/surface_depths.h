// SPDX-License-Identifier: Apache-2.0
// Finds how deep a surface without a fill lies, which only hides lines (METHOD §10).
#pragma once

#include <optional>
#include <vector>

#include "render/picture/seen_cluster.h"
#include "render/picture/tile_lists.h"
#include "render/raster/pixel_rect.h"
#include "render/strokes/drawn_structure.h"

namespace sline::render {

/// Names the samples of a grid from `area`'s corner on: sample (0, 0) has the grid's own corner.
struct SampleArea {
  SampleGrid grid;
  PixelRect area;
};

/// Returns the window depth of the nearest triangle at each sample, in rows from the bottom, 1
/// where there is none: what a driver's depth buffer would hold if it drew `visibleTriangles`.
/// Clusters outside the squares are left out. Software drivers, which set triangles up on one
/// thread, take several times as long. Returns nothing where the surface reaches behind the eye or
/// beyond the view's depths, and has to be clipped.
std::optional<std::vector<float>> surfaceDepths(const DrawnStructure& shown,
                                                const PictureView& view, const TileMask& squares,
                                                const SampleArea& samples);

}  // namespace sline::render
