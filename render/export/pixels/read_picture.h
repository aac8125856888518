// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "render/export/pixels/pixel_module.h"

namespace sline::render {

/// The picture in a file of PNG, TIFF, EXR, JPEG, WebP or JPEG 2000, as its bytes and not its name
/// say: with 16 bits a channel, whatever it has; grey as three equal ones; halves and floats as
/// sRGB, what is brighter than white being white. Fails for other kinds, for what is damaged or
/// beyond the limits, and where the module is absent.
Result<PixelRows> readPicture(const std::filesystem::path& file, const PictureLimits& limits = {});

}  // namespace sline::render
