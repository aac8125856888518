// SPDX-License-Identifier: Apache-2.0
// Encodes what is painted on a mesh as bytes that a general compressor makes small: most of it is
// nothing, and the rest stands together where the mesh's vertices do.
#pragma once

#include <string>
#include <string_view>

#include "model/base/result.h"
#include "model/geometry/paint.h"

namespace sline::model {

/// Returns 8 + vertices bytes; resources/help/scene_file.md describes them.
std::string encodedPaint(const Paint& paint);

/// Returns the paint again. The bytes are not trusted: the error says what is wrong with them.
Result<Paint> decodedPaint(std::string_view bytes);

}  // namespace sline::model
