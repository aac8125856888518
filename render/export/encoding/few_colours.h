// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "render/raster/image.h"

namespace sline::render {

/// Returns an opaque image as a PNG with at most that many colours (2 to 256), which is a third as
/// large as one with all of them: for small pictures that come with the program. The colours are
/// chosen by halving the box of colours that holds the largest errors (P. Heckbert, "Color image
/// quantization for frame buffer display", 1982).
std::string pngOfFewColours(const Image& image, int colours);

}  // namespace sline::render
