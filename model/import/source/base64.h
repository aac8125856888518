// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace sline::model {

/// Returns the bytes of base64 text (RFC 4648 §4), padding optional, white space skipped; nothing
/// where another character occurs or the length does not fit.
std::optional<std::string> decodeBase64(std::string_view text);

/// Returns the first `count` bytes of base64 text, or nothing where it holds fewer; the text behind
/// them is not looked at.
std::optional<std::string> decodeBase64Prefix(std::string_view text, std::size_t count);

}  // namespace sline::model
