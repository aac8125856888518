// SPDX-License-Identifier: Apache-2.0
// Shows how each structure is drawn on a small body of its own, which a legend's reader compares
// with the figure.
#pragma once

#include <vector>

#include "render/export/order/export_order.h"
#include "render/vectors/vector_drawing.h"

namespace sline::render {

inline constexpr glm::vec2 sampleMm{8.0f, 4.8f};

/// Returns a drawing of `sampleMm` for each structure, with its style, light and background, and
/// with pens as wide as in a figure of that height.
Result<std::vector<VectorDrawing>> styleSamples(const ExportOrder& order,
                                                const std::vector<model::NodeId>& structures);
/// Returns a drawing of `sampleMm` of a body whose outline goes on that way behind another one.
Result<VectorDrawing> hiddenLinesSample(const ExportOrder& order, model::HiddenLines how);

}  // namespace sline::render
