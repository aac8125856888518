// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/export/order/export_order.h"
#include "render/export/pixels/pixel_kind.h"
#include "render/raster/image.h"

namespace sline::render {

/// Returns about how many bytes a file of that kind takes, given a smaller picture of the same
/// page: that is encoded as the file will be, once as it is and once half as large, and what the
/// pixels cost is carried on to as many as the file has. 0 where it cannot be encoded.
double pixelWeight(const ExportOrder& order, PixelKind kind, const Image& page);

}  // namespace sline::render
