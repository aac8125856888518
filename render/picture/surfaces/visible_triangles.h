// SPDX-License-Identifier: Apache-2.0
// Finds which triangles of a surface leave a trace in the picture (METHOD §10).
#pragma once

#include <cstdint>
#include <vector>

#include "render/drawn/drawn_structure.h"
#include "render/drawn/picture_view.h"
#include "render/picture/surfaces/tile_lists.h"
#include "render/software/seen_cluster.h"

namespace sline::render {

/// Returns the triangles that may cover a sample in the squares, three indices into
/// `Clusters::vertices` each; of a surface with an outside only, those that turn it to the eye. In
/// a fine mesh most triangles lie between the samples; software drivers, which set
/// triangles up on one thread, are spared them, and a graphics card does not lose either.
std::vector<std::uint32_t> visibleTriangles(const DrawnStructure& shown, const PictureView& view,
                                            const TileMask& squares, const SampleGrid& grid = {});

}  // namespace sline::render
