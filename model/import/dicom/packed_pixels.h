// SPDX-License-Identifier: Apache-2.0
// Provides the small steps of unpacking pixel data that the library's decoders do not take.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sline::model {

using Fragments = std::span<const std::string_view>;

std::string joined(Fragments fragments);

/// Unpacks the pixels from `first` on, the lowest bit of a byte first; as many as `values` has room
/// for.
void unpackBits(std::string_view bytes, std::size_t first, std::vector<std::uint16_t>& values);

/// Unpacks one plane of a frame in runs (PS3.5 annex G) to `wanted` bytes; returns nothing where it
/// is damaged. Pixels of one byte, and pixels packed eight to a byte, have one plane, those of two
/// bytes have the high and then the low one.
std::optional<std::string> unpackedRuns(std::string_view frame, std::size_t plane,
                                        std::size_t wanted);

/// Tells whether a JPEG or JPEG-LS stream says, ahead of its data, that it has these columns and
/// rows: the decoder allocates memory for whatever size it says.
bool hasJpegSize(std::string_view stream, const glm::ivec2& size);

}  // namespace sline::model
