// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace sline::render {

/// Returns text of any origin as XML 1.0 may hold it, between tags or in double quotes: markup is
/// escaped, and anything that is not UTF-8, not a character of XML or would break the line becomes
/// U+FFFD.
std::string xmlText(std::string_view text);

/// Returns text of any origin as one line of UTF-8: blanks replace what breaks the line, U+FFFD
/// what is not a character; there are no blanks at its ends.
std::string plainLine(std::string_view text);

}  // namespace sline::render
