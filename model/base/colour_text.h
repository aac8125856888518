// SPDX-License-Identifier: Apache-2.0
// Converts colours to and from the text that people and files write: "#a0523c".
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "model/base/units.h"

namespace sline {

/// Returns "#rrggbb" in small letters.
std::string colourText(const Colour& colour);
/// Returns the colour that "#rrggbb" names, in small letters or capitals, or nothing for any other
/// text.
std::optional<Colour> colourFrom(std::string_view text);

}  // namespace sline
