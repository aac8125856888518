// SPDX-License-Identifier: Apache-2.0
// Tells texts in UTF-8 from other bytes, and makes such texts of them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace sline {

/// Tells whether all of the bytes are UTF-8 as Unicode defines it: no half characters, none written
/// longer than need be, no surrogates.
bool isUtf8(std::string_view text);

/// Returns the text with U+FFFD in place of bytes that stand for no character.
std::string inUtf8(std::string_view text);

/// Returns as much of a text in UTF-8 as so many bytes hold, in whole characters.
std::string_view cutUtf8(std::string_view text, std::size_t bytes);

}  // namespace sline
