// SPDX-License-Identifier: Apache-2.0
#include "model/import/source/base64.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace sline::model {

namespace {
constexpr std::uint8_t notADigit = 255;
constexpr std::uint8_t space = 254;
constexpr std::uint8_t padding = 253;

constexpr std::array<std::uint8_t, 256> makeTable() {
  std::array<std::uint8_t, 256> table{};
  for (std::uint8_t& entry : table)
    entry = notADigit;
  constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t i = 0; i < digits.size(); ++i)
    table[static_cast<unsigned char>(digits[i])] = std::uint8_t(i);
  for (const char c : {' ', '\t', '\n', '\r'})
    table[static_cast<unsigned char>(c)] = space;
  table['='] = padding;
  return table;
}
constexpr std::array<std::uint8_t, 256> table = makeTable();

std::optional<std::string> decode(std::string_view text, std::size_t count) {
  std::string bytes;
  bytes.reserve(std::min(count, text.size() / 4 * 3 + 3));
  std::uint32_t bits = 0;
  unsigned held = 0;  // digits in `bits`
  bool padded = false;
  for (const char c : text) {
    if (bytes.size() >= count)
      break;
    const std::uint8_t digit = table[static_cast<unsigned char>(c)];
    if (digit == space)
      continue;
    if (digit == padding) {
      // VTK encodes a block's header by itself: its padding is followed by the block.
      if (count != std::string::npos)
        break;
      padded = true;
      continue;
    }
    if (digit == notADigit || padded)
      return std::nullopt;
    bits = bits << 6 | digit;
    if (++held == 4) {
      bytes += {char(bits >> 16), char(bits >> 8), char(bits)};
      held = 0;
    }
  }
  if (held == 1 && bytes.size() < count)
    return std::nullopt;
  if (held == 2)
    bytes += char(bits >> 4);
  if (held == 3)
    bytes += {char(bits >> 10), char(bits >> 2)};
  return bytes;
}
}  // namespace

std::optional<std::string> decodeBase64(std::string_view text) {
  return decode(text, std::string::npos);
}

std::optional<std::string> decodeBase64Prefix(std::string_view text, std::size_t count) {
  std::optional<std::string> bytes = decode(text, count);
  if (!bytes || bytes->size() < count)
    return std::nullopt;
  bytes->resize(count);
  return bytes;
}

}  // namespace sline::model
