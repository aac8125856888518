// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <vector>

#include "render/export/order/export_order.h"

namespace sline::widgets {

struct FinishedPages {
  std::vector<QImage> images;  ///< one, or those of a sheet
  render::ExportNotes notes;   ///< what is missing on them
};

/// Returns the page that the order's file has, given a picture of its scene: with what exports
/// write over it or, of a sheet, around it, so many pixels wide. It computes what hides labels, so
/// it must not run on the window's thread.
FinishedPages finishedPages(const QImage& picture, const render::ExportOrder& order, int width);

/// Returns the size of the paper: of a sheet its own, else that of the page.
glm::vec2 paperMm(const render::ExportOrder& order);

}  // namespace sline::widgets
