// SPDX-License-Identifier: Apache-2.0
#include "render/export/marks/plate_image.h"

#include <QImage>
#include <algorithm>
#include <cstring>

#include "render/export/marks/figure_plate.h"

namespace sline::render {

namespace {

LabelReport reportOf(const LabelPlate& plate) {
  LabelReport report;
  for (const ShownLabel& label : plate.labels)
    if (plate.layout.find(label.item.id))
      report.key.push_back({label.number, plainText(label)});
    else
      report.leftOut.push_back(plainText(label));
  return report;
}

}  // namespace

LabelReport drawPlate(Image& image, const ExportOrder& given, const Typesetting&) {
  const bool bare = given.labels.mode == LabelMode::off && given.marks == ExportMarks::none();
  if (bare || image.width < 1 || image.height < 1)
    return {};
  const float scale = float(image.height) / given.page.sizeMm.y;
  ExportOrder order = given;
  order.page.sizeMm.x = float(image.width) / scale;
  const FigurePlate plate = figurePlate(order);
  // QPainter blends right only where colours are multiplied by their alpha.
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

glm::vec2 shareBesidePlate(const ExportOrder& order, const Typesetting&) {
  // Fitted cameras leave 5 % on either side anyway.
  constexpr float airOfCameras = 1.06f;
  constexpr float least = 0.3f;
  const glm::vec2 page = order.page.sizeMm;
  const EdgeRoom edges = marksOf(order).edges;
  // What is said of sections may take more lines, in a corner that anatomy seldom reaches.
  const float rows = std::max(std::min(edges.top, edges.bottom), edges.top > 0.0f ? 6.0f : 0.0f);
  glm::vec2 room(2.0f * std::max(edges.left, edges.right), 2.0f * rows);
  glm::vec2 share = glm::min(glm::vec2(1.0f), airOfCameras * (1.0f - room / page));
  if (order.labels.mode != LabelMode::off) {
    const float columns = columnRoomMm(order.scene, order.labels, page.x);
    if (columns > 0.0f)
      share.x = std::min(share.x, 1.0f - (2.0f * columns + room.x) / page.x);
  }
  return glm::max(share, glm::vec2(least));
}

}  // namespace sline::render
