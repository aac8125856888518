// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>

#include "render/export/order/export_order.h"

namespace sline::widgets {

struct FinishedPage {
  QImage image;
  render::ExportNotes notes;  ///< what is not on it
};

/// A picture of the order's scene with what exports write over it. Asks what hides labels: nothing
/// for the window's thread.
FinishedPage finishedPage(const QImage& picture, const render::ExportOrder& order);

}  // namespace sline::widgets
