// SPDX-License-Identifier: Apache-2.0
#include "widgets/export/finished_page.h"

#include <QPainter>

#include "render/export/plate/figure_plate.h"

namespace sline::widgets {

FinishedPage finishedPage(const QImage& picture, const render::ExportOrder& order) {
  QImage page = picture.convertToFormat(QImage::Format_RGBA8888_Premultiplied);
  const qreal scale = qreal(picture.width()) / qreal(order.page.sizeMm.x);
  const render::FigurePlate plate = render::figurePlate(order);
  {
    QPainter painter(&page);
    painter.scale(scale, scale);
    render::paintPlate(painter, plate);
  }
  return {page, plate.notes};
}

}  // namespace sline::widgets
