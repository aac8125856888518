// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>

#include "render/export/order/export_order.h"

namespace sline::widgets {

/// A picture of the order's scene with what exports write over it. Asks what hides labels: nothing
/// for the window's thread.
QImage finishedPage(const QImage& picture, const render::ExportOrder& order);

}  // namespace sline::widgets
