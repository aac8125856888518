// SPDX-License-Identifier: Apache-2.0
// Writes and reads numbers as bytes, the lowest first, and makes small numbers of small
// differences.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>

namespace sline {

/// Maps a difference, taken modulo the numbers of its type, to a number that is small where the
/// difference is small in either sense: 0, −1, 1, −2, … → 0, 1, 2, 3, …
template <std::unsigned_integral Number>
constexpr Number zigzag(Number difference) {
  const bool negative = difference >> (std::numeric_limits<Number>::digits - 1) != 0;
  return Number(Number(difference << 1) ^ Number(negative ? ~Number(0) : Number(0)));
}
/// Reverts `zigzag`.
template <std::unsigned_integral Number>
constexpr Number unzigzag(Number code) {
  return Number(Number(code >> 1) ^ Number((code & 1u) != 0 ? ~Number(0) : Number(0)));
}

/// Writes four bytes.
inline void putWord(char* at, std::uint32_t word) {
  for (int i = 0; i < 4; ++i)
    at[i] = char(word >> (8 * i) & 0xffu);
}
/// Reads the four bytes that begin there; all of them must be there.
inline std::uint32_t wordAt(std::string_view bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < 4; ++i)
    word |= std::uint32_t(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
  return word;
}

}  // namespace sline
