// SPDX-License-Identifier: Apache-2.0
#include "render/export/marks/figure_plate.h"

namespace sline::render {

FigurePlate figurePlate(const ExportOrder& order, SightTrees& trees, const LabelTurn& turn) {
  FigurePlate plate{.labels = {}, .marks = marksOf(order)};
  if (order.labels.mode == LabelMode::off)
    return plate;
  LabelStyle style = order.labels;
  style.onDark = order.look.background == Background::dark;
  style.reserved = plate.marks.boxes;
  plate.labels =
      labelPlate(order.scene, Screen(order.camera, order.page.sizeMm), style, trees, turn);
  return plate;
}

FigurePlate figurePlate(const ExportOrder& order) {
  SightTrees trees;
  return figurePlate(order, trees);
}

void paintPlate(QPainter& painter, const FigurePlate& plate) {
  if (plate.labels)
    paintLabels(painter, *plate.labels);
  paintMarks(painter, plate.marks);
}

}  // namespace sline::render
