// SPDX-License-Identifier: Apache-2.0
// Writes finished images as files.
#pragma once

#include <filesystem>
#include <string>

#include "model/base/result.h"
#include "render/export/pixels/pixel_kind.h"
#include "render/raster/image.h"

namespace sline::render {

/// Fails for an extension in which no picture can be written; the error lists those that can.
Status checkImageName(const std::filesystem::path& file);

/// Writes the picture in the format of the file's extension: png and tiff (8 bit sRGB, straight
/// alpha, marked as such), exr (half floats in linear light, premultiplied alpha, as OpenEXR
/// requires), jpg (no alpha: on white), webp and jp2 (lossless). Where every pixel is opaque no
/// alpha is written. The file appears whole or not at all, and carries no path, user or date.
Status writeImage(const Image& image, const std::filesystem::path& file);

/// A file of rows at a place that is written to directly; see `model::writeBeside`.
Result<std::unique_ptr<RowFile>> rowFile(PixelKind kind, const PixelLayout& layout,
                                         const std::filesystem::path& file);

}  // namespace sline::render
