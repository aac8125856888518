// SPDX-License-Identifier: Apache-2.0
// Numbers and paths as few characters.
#pragma once

#include <string>

#include "render/vectors/path.h"

namespace sline::render {

/// Appends the number rounded to so many decimals, without needless zeros: "12.5", "-.04", "7".
void appendNumber(std::string& text, double value, int decimals);

/// The value of a path's `d`; points rounded to so many decimals, errors do not add up. Pieces that
/// are straight as far as that become lines.
std::string svgPath(const Path& path, int decimals);

}  // namespace sline::render
