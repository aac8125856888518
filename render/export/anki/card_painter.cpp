// SPDX-License-Identifier: Apache-2.0
#include "render/export/anki/card_painter.h"

#include <QPainterPath>
#include <algorithm>
#include <cstring>

#include "render/export/encoding/png_image.h"

namespace sline::render {

namespace {

/// Pixels: no screen for cards shows more, and collections are sent over networks.
constexpr int widestCard = 1600;

/// Returns a box at the side of the label's own box that faces the place, within the page.
LabelBox boxFor(const PlacedLabel& placed, const glm::vec2& place, const LabelStyle& style,
                float pageWidth) {
  const float height = 1.3f * lineHeightMm(style);
  const float width = 2.0f * height;
  const float middle = placed.box.middle().y;
  const bool before = placed.post == LabelPost::left ||
                      (placed.post != LabelPost::right && placed.box.middle().x < place.x);
  constexpr float margin = 0.5f;
  const float beside = before ? placed.box.high.x - width : placed.box.low.x;
  const float left = std::max(std::min(beside, pageWidth - margin - width), margin);
  return {{left, middle - 0.5f * height}, {left + width, middle + 0.5f * height}};
}

void paintMark(QPainter& painter, const LabelBox& box, const LabelStyle& style) {
  constexpr qreal line = 0.25;
  const QColor ink(17, 17, 17);
  const QRectF place(QPointF(qreal(box.low.x), qreal(box.low.y)),
                     QPointF(qreal(box.high.x), qreal(box.high.y)));
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(ink, line));
  painter.setBrush(QColor(255, 222, 120));
  painter.drawRoundedRect(place, 0.8, 0.8);
  const qreal scale = 1.15 * qreal(style.points * millimetresPerPoint) / qreal(labelFontPixels);
  QPainterPath letter;
  letter.addText(0.0, 0.0, labelFont(), QStringLiteral("?"));
  const QPointF middle = letter.boundingRect().center();
  painter.fillPath(QTransform(scale, 0.0, 0.0, scale, place.center().x() - scale * middle.x(),
                              place.center().y() - scale * middle.y())
                       .map(letter),
                   ink);
}

QImage clearPicture(const ExportOrder& order) {
  const glm::ivec2 size = cardPixels(order.page);
  QImage picture(size.x, size.y, QImage::Format_RGBA8888_Premultiplied);
  picture.fill(Qt::transparent);
  return picture;
}

}  // namespace

Result<std::string> paintedPng(const ExportOrder& order, QImage canvas,
                               const std::function<void(QPainter&)>& paint) {
  {
    QPainter painter(&canvas);
    painter.scale(qreal(canvas.width()) / qreal(order.page.sizeMm.x),
                  qreal(canvas.height()) / qreal(order.page.sizeMm.y));
    paint(painter);
  }
  const QImage drawn = canvas.convertToFormat(QImage::Format_RGBA8888);
  Image image{.width = drawn.width(), .height = drawn.height(), .rgba = {}};
  const std::size_t row = std::size_t(4) * std::size_t(drawn.width());
  image.rgba.resize(row * std::size_t(drawn.height()));
  for (int y = 0; y < drawn.height(); ++y)
    std::memcpy(&image.rgba[row * std::size_t(y)], drawn.constScanLine(y), row);
  return pngOf(image, order.credit);
}

glm::ivec2 cardPixels(const ExportPage& page) {
  const glm::ivec2 size = pixelsOf(page);
  return size.x > widestCard ? glm::max(size * widestCard / size.x, glm::ivec2(1)) : size;
}

ExportOrder forPhones(const ExportOrder& order) {
  ExportOrder large = order;
  large.labels.points =
      std::max(order.labels.points, phoneLetters * order.page.sizeMm.x / millimetresPerPoint);
  return large;
}

LabelPlate onlyThose(const LabelPlate& plate, const std::set<model::AnnotationId>& those) {
  LabelPlate some{.style = plate.style, .labels = {}, .texts = {}, .layout = plate.layout};
  if (some.style.ground == Background::transparent)  // cards lay it over the picture
    some.style.ground = Background::white;
  for (std::size_t i = 0; i < plate.labels.size(); ++i)
    if (those.contains(plate.labels[i].item.id)) {
      some.labels.push_back(plate.labels[i]);
      some.texts.push_back(plate.texts[i]);
    }
  return some;
}

Result<std::string> CardPainter::ground(const Image& drawn, const Marks& marks) const {
  const QImage picture(drawn.rgba.data(), drawn.width, drawn.height, qsizetype(4) * drawn.width,
                       QImage::Format_RGBA8888);
  return paintedPng(m_order, picture.convertToFormat(QImage::Format_RGBA8888_Premultiplied),
                    [&marks](QPainter& painter) { paintMarks(painter, marks); });
}

Result<std::string> CardPainter::labels(const LabelPlate& plate) const {
  return paintedPng(m_order, clearPicture(m_order),
                    [&plate](QPainter& painter) { paintLabels(painter, plate); });
}

void paintQuestion(QPainter& painter, const LabelPlate& plate,
                   const std::set<model::AnnotationId>& asked, float pageWidthMm) {
  LabelPlate silent = plate;
  std::vector<LabelBox> marks;
  for (std::size_t i = 0; i < silent.labels.size(); ++i) {
    ShownLabel& label = silent.labels[i];
    const PlacedLabel* placed = plate.layout.find(label.item.id);
    if (!placed || !asked.contains(label.item.id))
      continue;
    silent.texts[i].lines.clear();
    if (label.item.kind == model::AnnotationKind::callout)
      label.item.kind = model::AnnotationKind::label;  // without a box of its text's size
    marks.push_back(boxFor(*placed, label.item.places.front(), plate.style, pageWidthMm));
  }
  paintLabels(painter, silent);
  for (const LabelBox& mark : marks)
    paintMark(painter, mark, silent.style);
}

Result<std::string> CardPainter::question(const LabelPlate& plate,
                                          const std::set<model::AnnotationId>& asked) const {
  return paintedPng(m_order, clearPicture(m_order), [&](QPainter& painter) {
    paintQuestion(painter, plate, asked, m_order.page.sizeMm.x);
  });
}

}  // namespace sline::render
