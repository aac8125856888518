// SPDX-License-Identifier: Apache-2.0
// Films of a scene (`ExportOrder::film`), drawn and written frame by frame; whole or not at all.
#pragma once

#include "render/export/order/export_order.h"

namespace sline::render {

/// An animated WebP, again and again.
Status writeWebp(const ExportOrder& order, const std::filesystem::path& target,
                 const ExportProgress& progress);
/// An animated GIF of at most 255 colours, the same in all frames; again and again.
Status writeGif(const ExportOrder& order, const std::filesystem::path& target,
                const ExportProgress& progress);
/// H.264 where ffmpeg can, else MPEG-4.
Status writeMp4(const ExportOrder& order, const std::filesystem::path& target,
                const ExportProgress& progress);
/// A new folder of PNG files, frame_0001.png and so on; one that is there must be empty.
Status writeFrames(const ExportOrder& order, const std::filesystem::path& target,
                   const ExportProgress& progress);

/// What of the order a film does not have as it was said: odd heights, parts of frames, and of MP4
/// what is clear.
ExportNotes filmNotes(const ExportOrder& order, bool transparency);

}  // namespace sline::render
