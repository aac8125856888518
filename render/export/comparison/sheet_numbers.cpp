// SPDX-License-Identifier: Apache-2.0
#include "render/export/comparison/sheet_numbers.h"

#include <array>
#include <charconv>

namespace sline::render {

std::string shortNumber(float value) {
  std::array<char, 32> text{};
  const auto [end, failure] = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), end};
}

std::string threeDigits(double value) {
  const int decimals = value < 0.9995 ? 3 : value < 9.995 ? 2 : value < 99.95 ? 1 : 0;
  std::array<char, 64> text{};
  const auto [end, failure] = std::to_chars(text.data(), text.data() + text.size(), value,
                                            std::chars_format::fixed, decimals);
  return {text.data(), end};
}

std::string grouped(std::size_t count) {
  std::string text = std::to_string(count);
  for (std::size_t place = text.size(); place > 3; place -= 3)
    text.insert(place - 3, "\u202f");  // a narrow space that does not break
  return text;
}

}  // namespace sline::render
