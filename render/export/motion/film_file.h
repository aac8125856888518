// SPDX-License-Identifier: Apache-2.0
// Writes films of a scene (`ExportOrder::film`), drawn and written frame by frame; whole or not at
// all.
#pragma once

#include "render/export/order/export_order.h"

namespace sline::render {

/// Writes an animated WebP that repeats forever.
Status writeWebp(const ExportOrder& order, const std::filesystem::path& target,
                 const ExportProgress& progress);
/// Writes an animated GIF that repeats forever, with at most 255 colours, the same in all frames.
Status writeGif(const ExportOrder& order, const std::filesystem::path& target,
                const ExportProgress& progress);
/// Writes H.264 where ffmpeg can, else MPEG-4.
Status writeMp4(const ExportOrder& order, const std::filesystem::path& target,
                const ExportProgress& progress);
/// Writes a new folder of PNG files, frame_0001.png and so on; a folder that exists must be empty.
Status writeFrames(const ExportOrder& order, const std::filesystem::path& target,
                   const ExportProgress& progress);

/// Notes where a film cannot follow the order exactly: odd heights, parts of frames, and in MP4
/// clear pixels.
ExportNotes filmNotes(const ExportOrder& order, bool transparency);

}  // namespace sline::render
