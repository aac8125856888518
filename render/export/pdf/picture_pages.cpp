// SPDX-License-Identifier: Apache-2.0
#include "render/export/pdf/picture_pages.h"

#include <algorithm>
#include <cmath>

#include "render/lettering/lettering.h"

namespace sline::render {

namespace {

QRectF rectangle(const LabelBox& box) {
  return {QPointF(qreal(box.low.x), qreal(box.low.y)),
          QSizeF(qreal(box.size().x), qreal(box.size().y))};
}

/// Paints shapes one over the other; regions have holes.
void paintShapes(QPainter& painter, std::span<const VectorShape> shapes, bool regions) {
  for (const VectorShape& shape : shapes) {
    QPainterPath path = painterPath(shape.path);
    path.setFillRule(regions ? Qt::OddEvenFill : Qt::WindingFill);
    painter.setOpacity(qreal(shape.opacity));
    const QColor colour = painterColour(shape.colour);
    if (shape.penWidth > 0.0f)
      painter.strokePath(
          path, QPen(colour, qreal(shape.penWidth), Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    else
      painter.fillPath(path, colour);
  }
  painter.setOpacity(1.0);
}

/// Paints shapes that are transparent as a whole.
void paintGroup(QPainter& painter, std::span<const VectorShape> shapes, float opacity,
                bool regions) {
  constexpr float opaque = 0.999f;
  if (opacity >= opaque || shapes.empty()) {
    paintShapes(painter, shapes, regions);
    return;
  }
  QImage layer(painter.device()->width(), painter.device()->height(),
               QImage::Format_ARGB32_Premultiplied);
  layer.fill(Qt::transparent);
  {
    QPainter inner(&layer);
    inner.setRenderHints(painter.renderHints());
    inner.setTransform(painter.transform());
    paintShapes(inner, shapes, regions);
  }
  painter.save();
  painter.resetTransform();
  painter.setOpacity(qreal(opacity));
  painter.drawImage(0, 0, layer);
  painter.restore();
}

void paintFills(QPainter& painter, const VectorStructure& structure) {
  if (structure.tones) {
    const VectorTones& tones = *structure.tones;
    QPainterPath edge = painterPath(tones.edge);
    edge.setFillRule(Qt::OddEvenFill);
    painter.save();
    painter.setClipPath(edge, Qt::IntersectClip);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(rectangle({tones.at, tones.at + tones.sizeMm}),
                      QImage(tones.image.rgba.data(), tones.image.width, tones.image.height,
                             qsizetype(4) * tones.image.width, QImage::Format_RGBA8888));
    painter.restore();
  }
  paintGroup(painter, structure.fills, structure.fillOpacity, true);
}

}  // namespace

void paintDrawing(QPainter& painter, const VectorDrawing& drawing, const PdfPlacement& place) {
  painter.save();
  painter.setClipRect(rectangle(place.clip));
  if (drawing.background)
    painter.fillRect(rectangle(place.clip), painterColour(*drawing.background));
  painter.translate(qreal(place.at.x), qreal(place.at.y));
  for (const VectorStructure& structure : drawing.structures)
    paintFills(painter, structure);
  for (const VeiledLines& veiled : veiledLines(drawing))
    paintGroup(painter, veiled.shapes, veiled.lines->opacity, false);
  std::vector<const VectorStructure*> lined;
  for (const VectorStructure& structure : drawing.structures)
    lined.push_back(&structure);
  std::stable_sort(lined.begin(), lined.end(),
                   [](const auto* a, const auto* b) { return a->depth > b->depth; });
  for (const VectorStructure* structure : lined)
    for (const VectorLines& lines : structure->lines)
      paintGroup(painter, plainShapes(lines), lines.opacity, false);
  painter.restore();
}

PicturePages::PicturePages(const glm::vec2& sizeMm, int width)
    : m_scale(qreal(width) / qreal(sizeMm.x)),
      m_size(width, std::max(1, int(std::lround(m_scale * qreal(sizeMm.y))))) {
  newPage();
}

PicturePages::~PicturePages() = default;

void PicturePages::newPage() {
  m_painter.reset();
  m_pages.emplace_back(m_size, QImage::Format_RGB32);  // paper has no holes
  m_pages.back().fill(Qt::white);
  m_painter = std::make_unique<QPainter>(&m_pages.back());
  m_painter->scale(m_scale, m_scale);
}

void PicturePages::place(const VectorDrawing& drawing, const PdfPlacement& place) {
  paintDrawing(*m_painter, drawing, place);
}

std::vector<QImage> PicturePages::finish() {
  m_painter.reset();
  return std::move(m_pages);
}

}  // namespace sline::render
