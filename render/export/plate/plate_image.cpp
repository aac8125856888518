// SPDX-License-Identifier: Apache-2.0
#include "render/export/plate/plate_image.h"

#include <QImage>
#include <algorithm>
#include <cstring>
#include <glm/common.hpp>

#include "render/export/plate/figure_plate.h"
#include "render/lettering/column_widths.h"

namespace sline::render {

namespace {

LabelReport reportOf(const LabelPlate& plate) {
  LabelReport report;
  for (const ShownLabel& label : plate.labels) {
    const std::string text = keyText(label, plate.style);
    if (plate.layout.find(label.item.id))
      report.key.push_back({label.number, text});
    else
      report.leftOut.push_back(text);
  }
  return report;
}

/// At least this share of the page's sides is left to the anatomy.
constexpr float leastShare = 0.3f;

/// Returns what marks take of the page's width and height, both sides together.
glm::vec2 roomOfMarks(const ExportOrder& order) {
  const EdgeRoom edges = marksOf(order).edges;
  // Texts about sections may take more lines, in a corner that anatomy seldom reaches.
  const float rows = std::max(std::min(edges.top, edges.bottom), edges.top > 0.0f ? 6.0f : 0.0f);
  return {2.0f * std::max(edges.left, edges.right), 2.0f * rows};
}

glm::vec2 shareBeside(const glm::vec2& room, const glm::vec2& page) {
  // Fitted cameras leave 5 % on either side anyway.
  constexpr float airOfCameras = 1.06f;
  return glm::clamp(airOfCameras * (1.0f - room / page), glm::vec2(leastShare), glm::vec2(1.0f));
}

model::FreeSides sidesOfShare(const glm::vec2& share) {
  const double x = 0.5 * (1.0 - 0.9 * double(share.x));
  const double y = 0.5 * (1.0 - 0.9 * double(share.y));
  return {.left = x, .right = x, .top = y, .bottom = y};
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
  for (int y = 0; y < image.height; ++y)
    std::memcpy(&image.rgba[std::size_t(4) * std::size_t(y) * std::size_t(image.width)],
                drawn.constScanLine(y), std::size_t(4) * std::size_t(image.width));
  return plate.labels ? reportOf(*plate.labels) : LabelReport{};
}

LabelReport reportOfPlate(const ExportOrder& order, const Typesetting&) {
  const FigurePlate plate = figurePlate(order);
  return plate.labels ? reportOf(*plate.labels) : LabelReport{};
}

model::FreeSides sidesOfPlate(const ExportOrder& order, const Typesetting&) {
  const glm::vec2 page = order.page.sizeMm;
  const glm::vec2 marks = roomOfMarks(order);
  // The legend stands beside the anatomy, at its right.
  const std::optional<LabelBox> box = marksOf(order).legend;
  const float legend = box ? (page.x - box->low.x) / page.x : 0.0f;
  model::FreeSides sides = sidesOfShare(shareBeside(marks, page));
  sides.right = std::max(sides.right, double(legend));
  if (order.labels.mode == LabelMode::off)
    return sides;
  LabelStyle style = order.labels;
  style.edges.top = style.edges.bottom = 0.5f * marks.y;
  const ColumnWidths widths = widthsBesideFitted(order.scene, Screen(order.camera, page), style);
  if (widths.text <= 0.0f)
    return sides;
  // Millimetres by which the anatomy's outline exceeds its points.
  constexpr float outline = 1.0f;
  const float free = 0.5f * marks.x + 2.0f * outline;
  const auto column = [&](float width) {
    return width > 0.0f ? width + besideColumnMm() + outline : free;
  };
  glm::vec2 across = glm::vec2(column(widths.left), column(widths.right)) / page.x;
  across.y = std::max(across.y, legend);
  across *= std::min(1.0f, (1.0f - leastShare) / (across.x + across.y));
  const double row = std::min(0.35, double(0.5f * marks.y + outline) / double(page.y));
  return {.left = double(across.x), .right = double(across.y), .top = row, .bottom = row};
}

glm::vec2 shareBesidePlate(const ExportOrder& order, const Typesetting&) {
  const glm::vec2 page = order.page.sizeMm;
  const glm::vec2 marks = roomOfMarks(order);
  glm::vec2 share = shareBeside(marks, page);
  if (order.labels.mode != LabelMode::off) {
    const ColumnWidths widths =
        widthsBesideFitted(order.scene, Screen(order.camera, page), order.labels);
    const float widest = std::max(widths.left, widths.right);
    if (widest > 0.0f)
      share.x = std::min(share.x, 1.0f - (2.0f * (widest + besideColumnMm()) + marks.x) / page.x);
  }
  return glm::max(share, glm::vec2(leastShare));
}

}  // namespace sline::render
