// SPDX-License-Identifier: Apache-2.0
// Works on the four channels of a colour at once, as processors have it.
#pragma once

#include <bit>
#include <cstdint>
#include <glm/vec4.hpp>

namespace sline::render {

/// Red, green, blue and opacity.
using Channels = float __attribute__((vector_size(16)));

/// Returns a colour's channels, 0 … 255, red in the lowest 8 bits.
inline Channels channelsOf(std::uint32_t word) {
  using Bytes = std::uint8_t __attribute__((vector_size(4)));
  return __builtin_convertvector(std::bit_cast<Bytes>(word), Channels);
}

inline Channels channelsOf(const glm::vec4& colour) {
  return Channels{colour.x, colour.y, colour.z, colour.w};
}

/// Returns the colour whose channels these are, rounded to the nearest; they are at least 0, and
/// 255 where they are more.
inline std::uint32_t wordOf(Channels channels) {
  using Wholes = std::int32_t __attribute__((vector_size(16)));
  using Bytes = std::uint8_t __attribute__((vector_size(4)));
  const Channels most = Channels{} + 255.0f;
  const Channels least = channels < most ? channels : most;
  return std::bit_cast<std::uint32_t>(
      __builtin_convertvector(__builtin_convertvector(least + 0.5f, Wholes), Bytes));
}

}  // namespace sline::render
