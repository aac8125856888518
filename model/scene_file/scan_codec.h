// SPDX-License-Identifier: Apache-2.0
// Encodes a scan's voxels exactly, as bytes that a general compressor makes small: neighbours along
// a row differ by little, and the high bytes of their differences are nearly all zero (see
// mesh_codec.h).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "model/base/result.h"

namespace sline::model {

/// Returns 8 + 2 · voxels bytes; resources/help/scene_file.md describes them.
std::string encodedVoxels(const std::vector<std::int16_t>& voxels);

/// Returns the voxels again. The bytes are not trusted: the error says what is wrong with them.
Result<std::vector<std::int16_t>> decodedVoxels(std::string_view bytes);

}  // namespace sline::model
