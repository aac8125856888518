// SPDX-License-Identifier: Apache-2.0
// Finds the outlines of regions of pixels.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/raster/pixel_rect.h"
#include "render/vectors/path.h"

namespace sline::render {

/// Returns closed curves around the pixels that are not 0, in pixels of the picture; curves around
/// holes turn the other way. `inside` has a byte for each pixel of the area, row by row from the
/// bottom. Regions and holes smaller than `smallest` pixels are left out.
Path regionOutlines(std::span<const std::uint8_t> inside, const PixelRect& area, float smallest,
                    float tolerance);

}  // namespace sline::render
