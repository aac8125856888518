// SPDX-License-Identifier: Apache-2.0
#include "render/export/plate/plate_image.h"

#include <QImage>
#include <algorithm>
#include <cstring>
#include <glm/common.hpp>
#include <new>

#include "render/export/plate/figure_plate.h"
#include "render/export/plate/legend.h"
#include "render/lettering/column_widths.h"
#include "render/lettering/fitted_sides.h"
#include "render/lettering/looks_in_colour.h"

namespace sline::render {

namespace {

LabelReport reportOf(const ExportOrder& order, const FigurePlate& plate) {
  LabelReport report{.key = {}, .leftOut = {}, .marks = plate.marks.notes};
  if (!plate.labels)
    return report;
  for (const ShownLabel& label : plate.labels->labels) {
    const std::string text = keyLine(order.scene, label, plate.labels->style);
    if (plate.labels->layout.find(label.item.id))
      report.key.push_back({label.number, text});
    else
      report.leftOut.push_back(text);
  }
  return report;
}

/// Returns what marks take of the page.
RoomOfMarks roomOfMarks(const ExportOrder& order) {
  const Marks marks = marksOf(order);
  const EdgeRoom& edges = marks.edges;
  // Texts about sections may take more lines, in a corner that anatomy seldom reaches.
  const float rows =
      std::max(std::min(edges.top, edges.bottom - marks.foot), edges.top > 0.0f ? 6.0f : 0.0f);
  // The legend stands beside the anatomy, at its right.
  return {.size = {2.0f * std::max(edges.left, edges.right), 2.0f * rows},
          .legend = marks.legend ? order.page.sizeMm.x - marks.legend->low.x : 0.0f,
          // What the view says stands above it all.
          .foot = marks.caption ? std::max(marks.foot, edges.bottom - rows) : marks.foot};
}

}  // namespace

LabelReport drawPlate(Image& image, const ExportOrder& given, const Typesetting&) {
  if (given.bare() || image.width < 1 || image.height < 1)
    return {};
  const float scale = float(image.height) / given.page.sizeMm.y;
  ExportOrder order = given;
  order.page.sizeMm.x = float(image.width) / scale;
  const FigurePlate plate = figurePlate(order);
  // QPainter blends correctly only where colours are multiplied by their alpha.
  QImage canvas = QImage(image.rgba.data(), image.width, image.height, qsizetype(4) * image.width,
                         QImage::Format_RGBA8888)
                      .convertToFormat(QImage::Format_RGBA8888_Premultiplied);
  {
    QPainter painter(&canvas);
    painter.scale(qreal(scale), qreal(scale));
    paintPlate(painter, plate);
  }
  const QImage drawn = canvas.convertToFormat(QImage::Format_RGBA8888);
  if (drawn.height() != image.height)  // as where memory did not suffice
    throw std::bad_alloc();
  for (int y = 0; y < image.height; ++y)
    std::memcpy(&image.rgba[std::size_t(4) * std::size_t(y) * std::size_t(image.width)],
                drawn.constScanLine(y), std::size_t(4) * std::size_t(image.width));
  return reportOf(order, plate);
}

LabelReport reportOfPlate(const ExportOrder& order, const Typesetting&) {
  const FigurePlate plate = figurePlate(order);
  return reportOf(order, plate);
}

model::FreeSides sidesOfPlate(const ExportOrder& order, const Typesetting&) {
  return sidesBesideLabels(withLooksInColour(order.scene, order.labels.inColour), order.camera,
                           order.page.sizeMm, order.labels, roomOfMarks(order));
}

glm::vec2 shareBesidePlate(const ExportOrder& given, const Typesetting&) {
  // From all sides there is no view that says anything.
  ExportOrder order = given;
  order.viewName.clear();
  order.words = {};
  const glm::vec2 page = order.page.sizeMm;
  RoomOfMarks marks = roomOfMarks(order);
  marks.size.y += 2.0f * marks.foot;
  glm::vec2 share = shareBesideMarks(marks, page);
  if (order.labels.mode != LabelMode::off) {
    const ColumnWidths widths =
        widthsBesideFitted(withLooksInColour(order.scene, order.labels.inColour),
                           Screen(order.camera, page), order.labels);
    const float widest = std::max(widths.left, widths.right);
    if (widest > 0.0f)
      share.x =
          std::min(share.x, 1.0f - (2.0f * (widest + besideColumnMm()) + marks.size.x) / page.x);
  }
  return glm::max(share, glm::vec2(leastAnatomyShare));
}

}  // namespace sline::render
