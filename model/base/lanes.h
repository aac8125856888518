// SPDX-License-Identifier: Apache-2.0
// Works on four numbers at once, one of each of four things: processors have registers for that.
// What is written for `Number` works on a single one as well, with the same result.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace sline {

using Lanes = float __attribute__((vector_size(16)));
using WholeLanes = std::int32_t __attribute__((vector_size(16)));
inline constexpr std::size_t laneCount = 4;

inline Lanes squareRoot(Lanes x) {
  for (std::size_t lane = 0; lane < laneCount; ++lane)
    x[lane] = std::sqrt(x[lane]);
  return x;
}
inline float squareRoot(float x) {
  return std::sqrt(x);
}

/// Returns 1, or −1 where the sign is negative.
inline Lanes signOf(Lanes x) {
  using Words = std::uint32_t __attribute__((vector_size(16)));
  const Words words = std::bit_cast<Words>(x);
  return std::bit_cast<Lanes>((words & 0x80000000u) | 0x3f800000u);
}
inline float signOf(float x) {
  return std::copysign(1.0f, x);
}

/// What comparisons of lanes give: all bits are set where they hold.
using LaneMask = decltype(Lanes{} < Lanes{});

/// Returns a bit for each lane, the lowest for the first one.
inline unsigned bitsOf(LaneMask mask) {
#ifdef __SSE2__
  return unsigned(_mm_movemask_ps(std::bit_cast<__m128>(mask)));
#else
  const WholeLanes bits = std::bit_cast<WholeLanes>(mask) & WholeLanes{1, 2, 4, 8};
  return unsigned(bits[0] | bits[1] | bits[2] | bits[3]);
#endif
}

inline Lanes larger(Lanes a, Lanes b) {
  return a > b ? a : b;
}
inline Lanes smaller(Lanes a, Lanes b) {
  return a < b ? a : b;
}

/// A vector in space whose coordinates are numbers or lanes of them.
template <class Number>
struct Vector {
  Number x, y, z;

  friend Vector operator+(const Vector& a, const Vector& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  friend Vector operator-(const Vector& a, const Vector& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  friend Vector operator*(const Vector& a, Number by) { return {a.x * by, a.y * by, a.z * by}; }
  friend Vector operator/(const Vector& a, Number by) { return {a.x / by, a.y / by, a.z / by}; }
};

template <class Number>
Number dot(const Vector<Number>& a, const Vector<Number>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class Number>
Vector<Number> cross(const Vector<Number>& a, const Vector<Number>& b) {
  return {a.y * b.z - b.y * a.z, a.z * b.x - b.z * a.x, a.x * b.y - b.x * a.y};
}

/// Exchanges rows and columns of four by four numbers.
inline std::array<Lanes, laneCount> transposed(const std::array<Lanes, laneCount>& rows) {
  const Lanes a = __builtin_shufflevector(rows[0], rows[1], 0, 4, 1, 5);
  const Lanes b = __builtin_shufflevector(rows[2], rows[3], 0, 4, 1, 5);
  const Lanes c = __builtin_shufflevector(rows[0], rows[1], 2, 6, 3, 7);
  const Lanes d = __builtin_shufflevector(rows[2], rows[3], 2, 6, 3, 7);
  return {__builtin_shufflevector(a, b, 0, 1, 4, 5), __builtin_shufflevector(a, b, 2, 3, 6, 7),
          __builtin_shufflevector(c, d, 0, 1, 4, 5), __builtin_shufflevector(c, d, 2, 3, 6, 7)};
}

}  // namespace sline
