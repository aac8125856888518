// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace sline::render {

/// Text from anywhere as XML 1.0 may hold it, between tags or in double quotes: markup is escaped,
/// and what is no UTF-8, no character of XML or would break the line becomes U+FFFD.
std::string xmlText(std::string_view text);

/// Text from anywhere as one line of UTF-8: blanks for what breaks the line, U+FFFD for what is no
/// character; none at its ends.
std::string plainLine(std::string_view text);

}  // namespace sline::render
