// SPDX-License-Identifier: Apache-2.0
// Works on the four channels of a colour at once, as processors have it.
#pragma once

#include <bit>
#include <cstdint>
#include <glm/vec4.hpp>
#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace sline::render {

/// Red, green, blue and opacity.
using Channels = float __attribute__((vector_size(16)));

/// Returns a colour's channels, 0 … 255, red in the lowest 8 bits.
inline Channels channelsOf(std::uint32_t word) {
#ifdef __SSE2__
  // Compilers would convert the bytes one by one.
  const __m128i zero = _mm_setzero_si128();
  const __m128i bytes = _mm_cvtsi32_si128(std::bit_cast<int>(word));
  return _mm_cvtepi32_ps(_mm_unpacklo_epi16(_mm_unpacklo_epi8(bytes, zero), zero));
#else
  using Bytes = std::uint8_t __attribute__((vector_size(4)));
  return __builtin_convertvector(std::bit_cast<Bytes>(word), Channels);
#endif
}

inline Channels channelsOf(const glm::vec4& colour) {
  return Channels{colour.x, colour.y, colour.z, colour.w};
}

/// Returns the colour whose channels these are, rounded to the nearest; they are at least 0, and
/// 255 where they are more.
inline std::uint32_t wordOf(Channels channels) {
#ifdef __SSE2__
  // What is more than 255 becomes that as the bytes are packed.
  const __m128i wholes = _mm_cvttps_epi32(channels + 0.5f);
  const __m128i halves = _mm_packs_epi32(wholes, wholes);
  return std::bit_cast<std::uint32_t>(_mm_cvtsi128_si32(_mm_packus_epi16(halves, halves)));
#else
  using Wholes = std::int32_t __attribute__((vector_size(16)));
  using Bytes = std::uint8_t __attribute__((vector_size(4)));
  const Channels most = Channels{} + 255.0f;
  const Channels least = channels < most ? channels : most;
  return std::bit_cast<std::uint32_t>(
      __builtin_convertvector(__builtin_convertvector(least + 0.5f, Wholes), Bytes));
#endif
}

}  // namespace sline::render
