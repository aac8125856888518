// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/export/order/export_order.h"

namespace sline::render {

/// Writes a presentation of the order's views, or of what it shows, as a .pptx file.
Status writeSlides(const ExportOrder& order, const std::filesystem::path& target,
                   const ExportProgress& progress);

}  // namespace sline::render
