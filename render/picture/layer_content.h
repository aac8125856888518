// SPDX-License-Identifier: Apache-2.0
// Prepares what a picture's layers show: the parts of surfaces and the lines that they need.
#pragma once

#include <map>
#include <span>

#include "render/picture/layer_painter.h"
#include "render/strokes/surface_fill.h"

namespace sline::render {

/// Returns the fill of a structure in this picture; none where fills are left out.
SurfaceFill shownFill(const PictureInput& input, const PreparedStructure& shown);

/// Makes and uploads those parts of their surfaces that the changed layers need and no earlier
/// picture needed.
void completeSurfaces(const PictureInput& input, std::span<const Layer> layers,
                      std::span<const std::size_t> changed);

/// Finds the lines of all changed layers that have none in `lines` yet.
void findLines(const PictureInput& input, std::span<const Layer> layers,
               std::span<const std::size_t> changed, std::map<model::NodeId, StructureLines>& lines,
               Stopwatch& stopwatch);

}  // namespace sline::render
