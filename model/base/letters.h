// SPDX-License-Identifier: Apache-2.0
// Characters of names, whatever the locale.
#pragma once

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
/// All that is not ASCII counts as a letter.
inline bool isLetter(char c) {
  return isUpper(c) || isLower(c) || (c & '\x80') != 0;
}

}  // namespace sline
