// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace sline::render {

/// Returns the number's lowest `count` bytes, the highest first.
inline std::string bigEndian(std::uint64_t value, std::size_t count) {
  std::string bytes;
  for (std::size_t i = count; i-- > 0;)
    bytes.push_back(char((value >> (8 * i)) & 0xFF));
  return bytes;
}

}  // namespace sline::render
