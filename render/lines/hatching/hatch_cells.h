// SPDX-License-Identifier: Apache-2.0
// Finds which parts of a layout of strokes a view needs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "render/lines/ground/frustum.h"
#include "render/lines/ground/view_scale.h"
#include "render/lines/hatching/stroke_layout.h"

namespace sline::render {

/// Tells from where cells are looked at.
struct CellsView {
  const model::EyePoint& eye;
  const ViewScale& scale;
  const Frustum& frustum;
  float spacing;          ///< λ
  bool twoSided = false;  ///< see LineRequest
  std::size_t mostCells = mostHatchCells;
};

/// Returns all cells with strokes that a picture may show where the surface faces the eye, when
/// strokes of its finest level are `spacing` λ apart or up to twice as close. They are in ascending
/// order, so the coarsest come first. After the first one no level is taken of which not all are
/// among the most that are looked at.
std::vector<const KeptCell*> neededCells(StrokeLayout& layout, const CellsView& view);

}  // namespace sline::render
