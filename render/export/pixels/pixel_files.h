// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/export/order/export_order.h"
#include "render/export/pixels/pixel_kind.h"

namespace sline::render {

/// Pictures of the order's page in pixels, up to `pixelSideLimits.high` each way, drawn in bands
/// and written as they are drawn. PNG and TIFF say their resolution and are sRGB (or grey with its
/// curve): 8 or 16 bits with straight alpha where the background is transparent, or ink alone.
Status writePng(const ExportOrder& order, const std::filesystem::path& target,
                const ExportProgress& progress);
Status writeTiff(const ExportOrder& order, const std::filesystem::path& target,
                 const ExportProgress& progress);
/// Half floats in linear light, alpha multiplied in.
Status writeExr(const ExportOrder& order, const std::filesystem::path& target,
                const ExportProgress& progress);
/// 8 bits; what is transparent stands on white.
Status writeJpeg(const ExportOrder& order, const std::filesystem::path& target,
                 const ExportProgress& progress);

/// Lossless, 8 bits in colour; packed as a whole, so memory grows with the picture.
Status writeWebpPicture(const ExportOrder& order, const std::filesystem::path& target,
                        const ExportProgress& progress);
/// JPEG 2000: lossless, 8 or 16 bits; packed as a whole, too.
Status writeJp2(const ExportOrder& order, const std::filesystem::path& target,
                const ExportProgress& progress);

/// What of the order the kind does not hold: clear pixels, more bits.
ExportNotes pixelNotes(const ExportOrder& order, PixelKind kind);

}  // namespace sline::render
