// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "render/export/pixels/pixel_module.h"

namespace sline::render {

/// Returns the picture in a file of PNG, TIFF, EXR, JPEG, WebP or JPEG 2000, recognised by its
/// bytes and not its name. The result always has 16 bits per channel; grey becomes three equal
/// channels; halves and floats become sRGB, in which anything brighter than white is white. It
/// fails for other kinds, for damaged files, beyond the limits, and where the module is absent.
Result<PixelRows> readPicture(const std::filesystem::path& file, const PictureLimits& limits = {});

}  // namespace sline::render
