// SPDX-License-Identifier: Apache-2.0
#include "render/export/pixels/page_overlay.h"

#include <QImage>
#include <QPainter>

#include "render/export/plate/figure_plate.h"
#include "render/lettering/typesetting.h"

namespace sline::render {

struct PageOverlay::Data {
  std::unique_ptr<Typesetting> typesetting;
  std::optional<FigurePlate> plate;
  qreal pixelsPerMm = 1.0;
};

PageOverlay::PageOverlay() : m_data(std::make_unique<Data>()) {}
PageOverlay::~PageOverlay() = default;

Result<std::unique_ptr<PageOverlay>> PageOverlay::create(const ExportOrder& order,
                                                         glm::ivec2 pixels) {
  std::unique_ptr<PageOverlay> overlay(new PageOverlay);
  if (order.bare())
    return overlay;
  std::unique_ptr<Typesetting> made = TRY(Typesetting::create());
  Data& data = *overlay->m_data;
  data.typesetting = std::move(made);
  data.pixelsPerMm = qreal(pixels.y) / qreal(order.page.sizeMm.y);
  data.plate = figurePlate(order);
  return overlay;
}

const ExportNotes& PageOverlay::notes() const {
  static const ExportNotes none;
  return m_data->plate ? m_data->plate->notes : none;
}

void PageOverlay::paint(PixelRows& rows, int top) const {
  if (!m_data->plate)
    return;
  QImage canvas(reinterpret_cast<uchar*>(rows.rgba.data()), rows.width, rows.height,
                qsizetype(8) * rows.width, QImage::Format_RGBA64_Premultiplied);
  QPainter painter(&canvas);
  painter.translate(0.0, -qreal(top));
  painter.scale(m_data->pixelsPerMm, m_data->pixelsPerMm);
  paintPlate(painter, *m_data->plate);
}

}  // namespace sline::render
