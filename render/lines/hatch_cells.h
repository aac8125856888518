// SPDX-License-Identifier: Apache-2.0
// Finds which parts of a layout of strokes a view needs.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/lines/frustum.h"
#include "render/lines/stroke_layout.h"
#include "render/lines/view_scale.h"

namespace sline::render {

/// Returns the level, with its fraction, at which strokes are `spacing` λ apart where a millimetre
/// takes `perMm` λ.
float hatchLevel(const StrokeLayout& layout, float perMm, float spacing);

/// Returns all cells with strokes that a picture may show on these clusters when strokes of its
/// finest level are `spacing` λ apart or up to twice as close. They are in ascending order, so the
/// coarsest come first.
std::vector<LaidCell> neededCells(StrokeLayout& layout, std::span<const std::uint32_t> clusters,
                                  const ViewScale& scale, const Frustum& frustum, float spacing);

}  // namespace sline::render
