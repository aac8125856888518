// SPDX-License-Identifier: Apache-2.0
// Handles the letters of names and file endings; only ASCII letters count, whatever the locale.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>

namespace sline {

inline bool isDigit(char c) {
  return c >= '0' && c <= '9';
}
inline bool isUpper(char c) {
  return c >= 'A' && c <= 'Z';
}
inline bool isLower(char c) {
  return c >= 'a' && c <= 'z';
}
/// Tells whether the byte is a letter; every byte outside ASCII counts as one.
inline bool isLetter(char c) {
  return isUpper(c) || isLower(c) || (c & '\x80') != 0;
}

inline char lowerCase(char c) {
  return isUpper(c) ? char(c - 'A' + 'a') : c;
}
inline std::string lowerCase(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(), [](char c) { return lowerCase(c); });
  return lower;
}
inline bool equalsIgnoringCase(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return lowerCase(x) == lowerCase(y); });
}

/// Returns the file's last ending in small letters, with its dot, or an empty text where it has
/// none.
inline std::string lowerExtension(const std::filesystem::path& file) {
  return lowerCase(file.extension().string());
}

}  // namespace sline
