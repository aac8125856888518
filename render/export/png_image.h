// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "model/base/result.h"
#include "render/picture/image.h"

namespace sline::render {

/// The image as a PNG file that says nothing beside it; without alpha where nothing is clear.
Result<std::string> pngOf(const Image& image);

}  // namespace sline::render
