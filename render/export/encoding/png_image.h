// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "model/base/result.h"
#include "render/export/order/export_order.h"
#include "render/raster/image.h"

namespace sline::render {

/// Returns the image as a PNG file that says nothing besides it but the credit; there is no alpha
/// where no pixel is clear.
Result<std::string> pngOf(const Image& image, const ExportCredit& credit = {});

}  // namespace sline::render
