// SPDX-License-Identifier: Apache-2.0
// // Converts text in the character sets of DICOM (PS3.3 §C.12.1.1.2, PS3.5 §6.1).
#pragma once

#include <string>
#include <string_view>

namespace sline::model {

/// Returns `text` in UTF-8. `charset` is the value of Specific Character Set, several of them with
/// backslashes between; an empty one means ASCII. Characters that the set does not have become '?',
/// control characters become blanks.
std::string inUtf8(std::string_view text, const std::string& charset);

}  // namespace sline::model
