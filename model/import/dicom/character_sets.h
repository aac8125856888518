// SPDX-License-Identifier: Apache-2.0
// Text in the character sets of DICOM (PS3.3 §C.12.1.1.2, PS3.5 §6.1).
#pragma once

#include <string>
#include <string_view>

namespace sline::model {

/// `text` in UTF-8. `charset` is the value of Specific Character Set, several with backslashes
/// between; empty: ASCII. What the set does not have is '?', control characters are blanks.
std::string inUtf8(std::string_view text, const std::string& charset);

}  // namespace sline::model
