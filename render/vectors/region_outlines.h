// SPDX-License-Identifier: Apache-2.0
// The outlines of regions of pixels.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/raster/pixel_rect.h"
#include "render/vectors/path.h"

namespace sline::render {

/// Closed curves around the pixels that are not 0, those around holes turning the other way; in
/// pixels of the picture. `inside` has a byte for each pixel of the area, row by row from below.
/// Regions and holes smaller than `smallest` pixels are left out.
Path regionOutlines(std::span<const std::uint8_t> inside, const PixelRect& area, float smallest,
                    float tolerance);

}  // namespace sline::render
