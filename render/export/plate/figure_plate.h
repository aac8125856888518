// SPDX-License-Identifier: Apache-2.0
// Lays out everything written over a figure: its labels and, at its edges, its marks.
#pragma once

#include "render/export/plate/marks.h"
#include "render/lettering/label_painter.h"

namespace sline::render {

struct FigurePlate {
  std::optional<LabelPlate> labels;  ///< absent where the order wants none
  Marks marks;
  std::optional<LabelBox> frame;  ///< where the drawing ends, if not at the page's edge
  ExportNotes notes;              ///< labels and marks that are missing, and why
};

/// Lays out the labels and marks for the order's camera and page, labels beside the marks. Where
/// anatomy fills the page so that hardly any label finds ground, the drawing ends at a frame.
FigurePlate figurePlate(const ExportOrder& order, model::MeshTrees& trees,
                        const LabelTurn& turn = {});
FigurePlate figurePlate(const ExportOrder& order);

/// Returns the screen of the order's whole page.
Screen pageScreen(const ExportOrder& order);
/// Returns the screen of what a picture of the order shows: within its frame, if it gets one.
Screen screenSeen(const ExportOrder& order, model::MeshTrees& trees);

/// Paints the plate. The painter's unit must be a millimetre, from the picture's upper left corner.
void paintPlate(QPainter& painter, const FigurePlate& plate);

}  // namespace sline::render
