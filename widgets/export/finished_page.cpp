// SPDX-License-Identifier: Apache-2.0
#include "widgets/export/finished_page.h"

#include <QPainter>

#include "render/export/pdf/sheet_layout.h"
#include "render/export/pdf/sheet_options.h"
#include "render/export/pdf/sheet_pictures.h"
#include "render/export/plate/figure_plate.h"

namespace sline::widgets {

glm::vec2 paperMm(const render::ExportOrder& order) {
  return render::hasSheet(order) ? render::sheetLayout(order).paper : order.page.sizeMm;
}

FinishedPages finishedPages(const QImage& picture, const render::ExportOrder& order, int width) {
  if (render::hasSheet(order)) {
    FinishedPages pages;
    Result<std::vector<QImage>> sheet = render::sheetPictures(order, picture, width, &pages.notes);
    if (sheet.ok())
      pages.images = std::move(*sheet);
    return pages;
  }
  QImage page = picture.convertToFormat(QImage::Format_RGBA8888_Premultiplied);
  const qreal scale = qreal(picture.width()) / qreal(order.page.sizeMm.x);
  const render::FigurePlate plate = render::figurePlate(order);
  {
    QPainter painter(&page);
    painter.scale(scale, scale);
    render::paintPlate(painter, plate);
  }
  return {{page}, plate.notes};
}

}  // namespace sline::widgets
