// SPDX-License-Identifier: Apache-2.0
#include "model/base/natural_order.h"

#include <algorithm>
#include <string>

#include "model/base/letters.h"

namespace sline {

namespace {

/// Takes the run of digits at the front away and returns it without leading zeros.
std::string_view numberTaken(std::string_view& text) {
  const std::size_t length =
      std::size_t(std::find_if_not(text.begin(), text.end(), isDigit) - text.begin());
  std::string_view number = text.substr(0, length);
  text.remove_prefix(length);
  number.remove_prefix(std::min(number.find_first_not_of('0'), number.size()));
  return number;
}

/// Returns a number below, of or above zero as the first text stands before, with or after the
/// second.
int compared(std::string_view a, std::string_view b) {
  while (!a.empty() && !b.empty()) {
    if (isDigit(a.front()) && isDigit(b.front())) {
      const std::string_view first = numberTaken(a);
      const std::string_view second = numberTaken(b);
      if (first.size() != second.size())
        return first.size() < second.size() ? -1 : 1;
      if (const int order = first.compare(second); order != 0)
        return order;
      continue;
    }
    const auto first = static_cast<unsigned char>(lowerCase(a.front()));
    const auto second = static_cast<unsigned char>(lowerCase(b.front()));
    if (first != second)
      return first < second ? -1 : 1;
    a.remove_prefix(1);
    b.remove_prefix(1);
  }
  return int(!a.empty()) - int(!b.empty());
}

}  // namespace

bool naturallyBefore(std::string_view a, std::string_view b) {
  const int order = compared(a, b);
  return order != 0 ? order < 0 : a < b;
}

bool pathNaturallyBefore(const std::filesystem::path& a, const std::filesystem::path& b) {
  return std::lexicographical_compare(
      a.begin(), a.end(), b.begin(), b.end(),
      [](const std::filesystem::path& one, const std::filesystem::path& other) {
        return naturallyBefore(one.string(), other.string());
      });
}

}  // namespace sline
