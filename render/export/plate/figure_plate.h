// SPDX-License-Identifier: Apache-2.0
// All that is written over a figure: its labels and, at its edges, its marks.
#pragma once

#include "render/export/plate/marks.h"
#include "render/lettering/label_painter.h"

namespace sline::render {

struct FigurePlate {
  std::optional<LabelPlate> labels;  ///< where the order wants some
  Marks marks;
  ExportNotes notes;  ///< what of the labels and the marks is not there, and why
};

/// For the order's camera and page, labels beside the marks.
FigurePlate figurePlate(const ExportOrder& order, model::MeshTrees& trees,
                        const LabelTurn& turn = {});
FigurePlate figurePlate(const ExportOrder& order);

/// The painter's unit must be a millimetre, from the picture's upper left corner.
void paintPlate(QPainter& painter, const FigurePlate& plate);

}  // namespace sline::render
