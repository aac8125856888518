// SPDX-License-Identifier: Apache-2.0
// Frames a picture that anatomy fills: the drawing ends at a frame, as plates in atlases do, and
// its names stand on the ground around it.
#pragma once

#include "render/export/plate/marks.h"
#include "render/lettering/label_painter.h"

namespace sline::render {

/// Returns the frame that leaves the labels' columns and the marks' rows their room, with the
/// page's middle in its own; nothing where less than half of the page's width or height would be
/// left within it. Millimetres of the page.
std::optional<LabelBox> frameBeside(const ExportOrder& order, const LabelPlate& labels,
                                    const Marks& marks);

/// Returns the same view of what is within the frame.
Screen screenWithin(const Screen& page, const LabelBox& frame);

/// Returns what of the area is within the frame.
SeenArea areaWithin(SeenArea area, const LabelBox& frame);

/// Lays out the labels of what is within the frame, with columns beside it. The style's edges and
/// reserved boxes, and what comes back, are in millimetres of the page.
LabelPlate labelsBesideFrame(const ExportOrder& order, const LabelStyle& style,
                             const LabelBox& frame, model::MeshTrees& trees, const LabelTurn& turn);

/// Covers what is outside the frame with ground, below all other marks, and draws the frame.
void addFrame(Marks& marks, const LabelBox& frame, const ExportOrder& order);

}  // namespace sline::render
