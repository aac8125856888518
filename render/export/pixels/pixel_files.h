// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/export/order/export_order.h"
#include "render/export/pixels/pixel_kind.h"

namespace sline::render {

/// These write the order's page as a picture in pixels, up to `pixelSideLimits.high` each way,
/// drawn in bands and written as they are drawn. PNG and TIFF state their resolution and are sRGB
/// (or grey with its curve): 8 or 16 bits with straight alpha where the background is transparent,
/// or ink alone.
Status writePng(const ExportOrder& order, const std::filesystem::path& target,
                const ExportProgress& progress);
Status writeTiff(const ExportOrder& order, const std::filesystem::path& target,
                 const ExportProgress& progress);
/// Writes half floats in linear light with premultiplied alpha.
Status writeExr(const ExportOrder& order, const std::filesystem::path& target,
                const ExportProgress& progress);
/// Writes 8 bits per channel; transparent parts stand on white.
Status writeJpeg(const ExportOrder& order, const std::filesystem::path& target,
                 const ExportProgress& progress);

/// Writes lossless pictures with 8 bits in colour; they are packed as a whole, so memory grows with
/// the picture.
Status writeWebpPicture(const ExportOrder& order, const std::filesystem::path& target,
                        const ExportProgress& progress);
/// Writes JPEG 2000: lossless, with 8 or 16 bits; also packed as a whole.
Status writeJp2(const ExportOrder& order, const std::filesystem::path& target,
                const ExportProgress& progress);

/// Returns how a file of that kind holds a picture of so many pixels.
PixelLayout layoutOf(const ExportOrder& order, PixelKind kind, glm::ivec2 size);
/// Tells whether each of its pixels is ink or paper.
bool isInkAlone(const ExportOrder& order, PixelKind kind);

/// Notes what the order asks for and the kind does not hold: clear pixels, more bits.
ExportNotes pixelNotes(const ExportOrder& order, PixelKind kind);

}  // namespace sline::render
