// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace sline::render {

/// What every PNG begins with.
inline constexpr std::string_view pngSignature = "\x89PNG\r\n\x1A\n";

/// Returns a chunk of a PNG: length, name, data and checksum.
std::string pngChunk(std::string_view name, std::string_view data);

/// Returns the chunks that say sRGB, also to readers that do not know that one.
std::string pngSrgbChunks();

}  // namespace sline::render
