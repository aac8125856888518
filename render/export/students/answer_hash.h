// SPDX-License-Identifier: Apache-2.0
// Hides names that are answers, so that a page can tell right from wrong and still names nothing.
#pragma once

#include <string>
#include <string_view>

namespace sline::render {

/// Returns a name as answers are compared: in Unicode's compatible decomposition without marks, in
/// lower case, of letters and digits alone. The page's script does the same
/// (resources/page/words.js).
std::string normalisedAnswer(std::string_view name);

/// Returns the first 16 hexadecimal digits of the SHA-256 of the salt and the normalised name.
std::string answerHash(const std::string& salt, std::string_view name);

/// Returns the SHA-256 of the bytes as hexadecimal digits.
std::string sha256Hex(std::string_view bytes);
/// Returns it in base64, as a Content-Security-Policy names what may run: "sha256-…".
std::string sha256Source(std::string_view bytes);

/// Returns the bytes in base64.
std::string base64(std::string_view bytes);

}  // namespace sline::render
