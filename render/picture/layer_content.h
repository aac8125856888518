// SPDX-License-Identifier: Apache-2.0
// Prepares what a picture's layers show: the parts of surfaces and the lines that they need.
#pragma once

#include <map>
#include <span>

#include "render/drawn/surface_fill.h"
#include "render/picture/layer_painter.h"

namespace sline::render {

/// Returns the fill of a structure in this picture; none where fills are left out.
SurfaceFill shownFill(const PictureInput& input, const PreparedStructure& shown);

/// Makes and uploads those parts of their surfaces that the changed layers need and no earlier
/// picture needed.
void completeSurfaces(const PictureInput& input, std::span<const Layer> layers,
                      std::span<const std::size_t> changed);

/// Finds the lines of all changed layers, those that `input.lines` lacks, and from these the
/// layers' strokes, squares and triangles. One layer is completed after the other, so that what is
/// looked at for its lines is still near the processor for all that follows. Where the picture is
/// unwanted, some layers stay incomplete.
void completeLayers(const PictureInput& input, const PixelRect& region, std::span<Layer> layers,
                    std::span<const std::size_t> changed, Stopwatch& stopwatch);

}  // namespace sline::render
