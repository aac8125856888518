// SPDX-License-Identifier: Apache-2.0
#include "widgets/export/finished_page.h"

#include <QPainter>

#include "render/export/label_painter.h"

namespace sline::widgets {

QImage finishedPage(const QImage& picture, const render::ExportOrder& order) {
  QImage page = picture.convertToFormat(QImage::Format_RGBA8888_Premultiplied);
  if (order.labels.mode == render::LabelMode::off || order.scene.annotations().empty())
    return page;
  const float scale = float(picture.width()) / order.page.sizeMm.x;
  const render::Screen screen(order.camera, {order.page.sizeMm.x, float(picture.height()) / scale});
  render::SightTrees trees;
  const render::LabelPlate plate = render::labelPlate(order.scene, screen, order.labels, trees);
  QPainter painter(&page);
  painter.scale(qreal(scale), qreal(scale));
  render::paintLabels(painter, plate);
  return page;
}

}  // namespace sline::widgets
