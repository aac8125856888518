// SPDX-License-Identifier: Apache-2.0
// Pixel files through OpenImageIO.
#pragma once

#include <filesystem>
#include <string>

#include "model/base/result.h"
#include "render/picture/image.h"

namespace sline::cli {

/// Fails for an extension that no picture can be written to; the error lists those that can.
Status checkImageName(const std::filesystem::path& file);

/// Writes the picture in the format of the file's extension: png and tiff (8 bit sRGB, straight
/// alpha, marked as such), exr (half floats in linear light, alpha multiplied in, as OpenEXR
/// wants), jpg (no alpha: on white). Where every pixel is opaque no alpha is written. The file
/// appears whole or not at all, and carries no path, user or date.
Status writeImage(const render::Image& image, const std::filesystem::path& file);

/// The same as the bytes of a PNG file.
Result<std::string> pngBytes(const render::Image& image);

}  // namespace sline::cli
