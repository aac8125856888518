// SPDX-License-Identifier: Apache-2.0
// Takes frames one after the other, so that a film never lies in memory as pixels.
#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <memory>

#include "model/base/result.h"
#include "render/export/motion/gif_palette.h"
#include "render/export/order/export_order.h"
#include "render/raster/image.h"

namespace sline::render {

struct FilmShape {
  glm::ivec2 size{0};
  int frames = 0;
  int framesPerSecond = 25;
  bool transparent = false;  ///< else every pixel is opaque
  ExportCredit credit = {};
};

class FilmSink {
 public:
  virtual ~FilmSink() = default;
  /// Adds a frame, which must have the film's size.
  virtual Status add(const Image& frame) = 0;
  /// Ends the film after the last frame: the file is whole when this succeeds. Without this call
  /// the written part is of no use, and processes that were started end with the sink.
  virtual Status finish() = 0;
};
using NewSink = Result<std::unique_ptr<FilmSink>>;

/// Each of these begins its file at once, so that a file that cannot be written is known before
/// anything is drawn.
NewSink webpSink(const std::filesystem::path& file, const FilmShape& shape);
NewSink gifSink(const std::filesystem::path& file, const FilmShape& shape, GifPalette palette);
/// Writes through the program ffmpeg; the error says where it is missing.
NewSink mp4Sink(const std::filesystem::path& file, const FilmShape& shape);
/// Writes "frame_0001.png" … to an existing folder.
NewSink frameSink(const std::filesystem::path& folder, const FilmShape& shape);

/// Returns the error for a file that cannot be written, with the system's reason (errno).
Error filmNotWritten(const std::filesystem::path& file, int code);

}  // namespace sline::render
