// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace sline::render {

/// Rounds a number of 0 or more, below 2³¹, to the nearest whole one: unlike `std::lround` in a way
/// that compilers do with several at once.
inline std::uint32_t nearestWhole(float x) {
  const float above = x + 0.5f;
  return std::uint32_t(std::int32_t(above));
}

}  // namespace sline::render
