// SPDX-License-Identifier: Apache-2.0
// Shows a sheet before it is written.
#pragma once

#include <QImage>
#include <vector>

#include "render/export/order/export_order.h"

namespace sline::render {

/// Returns pictures of the pages that `sheetDocument` makes of the order, so many pixels wide: what
/// sets the pages of the file sets these. In the figure's place stands `figure`, a picture of the
/// order's scene and camera without labels, of any size. `notes`, if given, receives what the pages
/// lack.
Result<std::vector<QImage>> sheetPictures(const ExportOrder& order, const QImage& figure, int width,
                                          ExportNotes* notes = nullptr);

}  // namespace sline::render
