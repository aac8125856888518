// SPDX-License-Identifier: Apache-2.0
// Unpacks JPEG 2000 (ISO/IEC 15444-1 and -15, HTJ2K) by means of OpenJPEG.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sline::model {

/// Unpacks one component of `size` columns and rows, up to 16 bits each, signed values as two's
/// complement; `values` has as many entries. Returns a message that says what is wrong, or nothing.
/// Nothing larger than the requested size is ever unpacked.
std::optional<std::string> decodeJpeg2000(std::string_view stream, const glm::ivec2& size,
                                          std::vector<std::uint16_t>& values);

}  // namespace sline::model
