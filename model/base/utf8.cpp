// SPDX-License-Identifier: Apache-2.0
#include "model/base/utf8.h"

#include <algorithm>

namespace sline {

namespace {

std::size_t byteAt(std::string_view text, std::size_t i) {
  return static_cast<unsigned char>(text[i]);
}

bool goesOn(std::string_view text, std::size_t i) {
  return (byteAt(text, i) & 0xc0u) == 0x80u;
}

/// Returns how many bytes the character at the beginning has; 0 where there is none. The second
/// byte's limits are those of table 3-7 of the Unicode standard.
std::size_t lengthOfFirst(std::string_view text) {
  const std::size_t first = byteAt(text, 0);
  if (first < 0x80)
    return 1;
  const std::size_t length = first < 0xc2   ? 0
                             : first < 0xe0 ? 2
                             : first < 0xf0 ? 3
                             : first < 0xf5 ? 4
                                            : 0;
  if (length == 0 || text.size() < length)
    return 0;
  for (std::size_t i = 1; i < length; ++i)
    if (!goesOn(text, i))
      return 0;
  const std::size_t second = byteAt(text, 1);
  const bool sound = !(first == 0xe0 && second < 0xa0) && !(first == 0xed && second > 0x9f) &&
                     !(first == 0xf0 && second < 0x90) && !(first == 0xf4 && second > 0x8f);
  return sound ? length : 0;
}

}  // namespace

bool isUtf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = lengthOfFirst(text);
    if (length == 0)
      return false;
    text.remove_prefix(length);
  }
  return true;
}

std::string inUtf8(std::string_view text) {
  constexpr std::string_view unknown = "\xef\xbf\xbd";
  std::string all;
  all.reserve(text.size());
  while (!text.empty()) {
    const std::size_t length = lengthOfFirst(text);
    all += length == 0 ? unknown : text.substr(0, length);
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return all;
}

std::string_view cutUtf8(std::string_view text, std::size_t bytes) {
  if (text.size() <= bytes)
    return text;
  while (bytes > 0 && goesOn(text, bytes))
    --bytes;
  return text.substr(0, bytes);
}

}  // namespace sline
