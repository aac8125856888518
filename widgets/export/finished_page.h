// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>

#include "render/export/order/export_order.h"

namespace sline::widgets {

struct FinishedPage {
  QImage image;
  render::ExportNotes notes;  ///< what is missing on it
};

/// Returns a picture of the order's scene with what exports write over it. It computes what hides
/// labels, so it must not run on the window's thread.
FinishedPage finishedPage(const QImage& picture, const render::ExportOrder& order);

}  // namespace sline::widgets
