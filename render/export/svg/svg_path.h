// SPDX-License-Identifier: Apache-2.0
// Writes numbers and paths in few characters.
#pragma once

#include <string>

#include "render/vectors/path.h"

namespace sline::render {

/// Appends the number rounded to so many decimals, without needless zeros: "12.5", "-.04", "7".
void appendNumber(std::string& text, double value, int decimals);

/// Returns the value of a path's `d`; points are rounded to so many decimals and errors do not add
/// up. Pieces that are straight to that precision become lines.
std::string svgPath(const Path& path, int decimals);

}  // namespace sline::render
