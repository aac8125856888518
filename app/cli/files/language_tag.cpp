// SPDX-License-Identifier: Apache-2.0
#include "app/cli/files/language_tag.h"

#include <algorithm>

namespace sline::cli {

bool isLanguageTag(std::string_view tag) {
  constexpr std::size_t longest = 35;
  constexpr std::size_t longestPart = 8;
  if (tag.size() > longest)
    return false;
  std::size_t begin = 0;
  for (bool first = true; begin <= tag.size(); first = false) {
    const std::size_t end = std::min(tag.find('-', begin), tag.size());
    const std::string_view part = tag.substr(begin, end - begin);
    const auto fits = [first](char c) {
      return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (!first && c >= '0' && c <= '9');
    };
    if (part.size() < (first ? 2u : 1u) || part.size() > longestPart ||
        !std::all_of(part.begin(), part.end(), fits))
      return false;
    begin = end + 1;
  }
  return true;
}

}  // namespace sline::cli
