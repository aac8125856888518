// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "model/base/result.h"
#include "render/raster/image.h"

namespace sline::render {

/// Returns the image as a small WebP file for web pages: opaque, on white, and not exact. Quality
/// runs from 0 (smallest) to 100.
Result<std::string> webpOf(const Image& image, float quality);

}  // namespace sline::render
