// SPDX-License-Identifier: Apache-2.0
#include "model/base/colour_text.h"

#include <charconv>

namespace sline {

std::string colourText(const Colour& colour) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text = "#";
  for (const std::uint8_t channel : {colour.red, colour.green, colour.blue}) {
    text += digits[channel >> 4];
    text += digits[channel & 15];
  }
  return text;
}

std::optional<Colour> colourFrom(std::string_view text) {
  if (text.size() != 7 || text.front() != '#')
    return std::nullopt;
  unsigned value = 0;
  const char* const end = text.data() + text.size();
  const auto [next, fault] = std::from_chars(text.data() + 1, end, value, 16);
  if (fault != std::errc() || next != end)
    return std::nullopt;
  return Colour{std::uint8_t(value >> 16), std::uint8_t(value >> 8), std::uint8_t(value)};
}

}  // namespace sline
