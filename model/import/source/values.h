// SPDX-License-Identifier: Apache-2.0
// Reads numbers in a file's body, binary of either byte order or text, behind one shape, so that a
// format that has both is parsed by one template.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <limits>

#include "model/import/source/text_cursor.h"

namespace sline::model {

enum class ScalarType : std::uint8_t {
  int8,
  uint8,
  int16,
  uint16,
  int32,
  uint32,
  int64,
  uint64,
  float32,
  float64
};

/// Tells whether no coordinate of the point is infinite or not a number.
inline bool isFinite(const glm::vec3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

/// Tells whether no entry of the matrix is infinite or not a number.
inline bool isFinite(const glm::dmat4& matrix) {
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row)
      if (!std::isfinite(matrix[column][row]))
        return false;
  return true;
}

constexpr std::size_t sizeOf(ScalarType type) {
  switch (type) {
    case ScalarType::int8:
    case ScalarType::uint8:
      return 1;
    case ScalarType::int16:
    case ScalarType::uint16:
      return 2;
    case ScalarType::int32:
    case ScalarType::uint32:
    case ScalarType::float32:
      return 4;
    default:
      return 8;
  }
}

/// The index of no vertex; a value that cannot be an index is read as this.
inline constexpr std::uint32_t noVertex = 0xffffffffu;

inline std::uint32_t indexFrom(std::int64_t value) {
  return value >= 0 && value < std::int64_t(noVertex) ? std::uint32_t(value) : noVertex;
}

/// Returns the T stored at `at` (aligned or not), its bytes reversed where `swap`.
template <class T>
T loadAs(const char* at, bool swap) {
  unsigned char bytes[sizeof(T)];
  std::memcpy(bytes, at, sizeof(T));
  if (swap)
    std::reverse(bytes, bytes + sizeof(T));
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}

/// Returns a double narrowed to float; beyond its range it is infinite, never undefined.
inline float narrowed(double value) {
  if (std::abs(value) <= double(std::numeric_limits<float>::max()) || !std::isfinite(value))
    return static_cast<float>(value);
  return std::numeric_limits<float>::infinity();
}

inline float loadFloat(ScalarType type, const char* at, bool swap) {
  switch (type) {
    case ScalarType::int8:
      return float(loadAs<std::int8_t>(at, swap));
    case ScalarType::uint8:
      return float(loadAs<std::uint8_t>(at, swap));
    case ScalarType::int16:
      return float(loadAs<std::int16_t>(at, swap));
    case ScalarType::uint16:
      return float(loadAs<std::uint16_t>(at, swap));
    case ScalarType::int32:
      return float(loadAs<std::int32_t>(at, swap));
    case ScalarType::uint32:
      return float(loadAs<std::uint32_t>(at, swap));
    case ScalarType::int64:
      return float(loadAs<std::int64_t>(at, swap));
    case ScalarType::uint64:
      return float(loadAs<std::uint64_t>(at, swap));
    case ScalarType::float32:
      return loadAs<float>(at, swap);
    case ScalarType::float64:
      return narrowed(loadAs<double>(at, swap));
  }
  return 0.0f;
}

/// Returns a real number as a whole one, or −1 where it is none.
inline std::int64_t wholeNumber(double value) {
  return std::abs(value) < 9e15 && value == std::floor(value) ? std::int64_t(value) : -1;
}

inline std::int64_t loadInteger(ScalarType type, const char* at, bool swap) {
  switch (type) {
    case ScalarType::int8:
      return loadAs<std::int8_t>(at, swap);
    case ScalarType::uint8:
      return loadAs<std::uint8_t>(at, swap);
    case ScalarType::int16:
      return loadAs<std::int16_t>(at, swap);
    case ScalarType::uint16:
      return loadAs<std::uint16_t>(at, swap);
    case ScalarType::int32:
      return loadAs<std::int32_t>(at, swap);
    case ScalarType::uint32:
      return loadAs<std::uint32_t>(at, swap);
    case ScalarType::int64:
      return loadAs<std::int64_t>(at, swap);
    case ScalarType::uint64:
      return std::int64_t(std::min<std::uint64_t>(loadAs<std::uint64_t>(at, swap), INT64_MAX));
    case ScalarType::float32:
      return wholeNumber(double(loadAs<float>(at, swap)));
    case ScalarType::float64:
      return wholeNumber(loadAs<double>(at, swap));
  }
  return -1;
}

/// Reads binary values one after another. Every read returns false, without moving, past the end.
class BinaryValues {
 public:
  static constexpr bool text = false;
  BinaryValues(const char* at, const char* end, std::endian order)
      : m_at(at), m_end(end), m_swap(order != std::endian::native) {}

  const char* at() const { return m_at; }
  bool swap() const { return m_swap; }
  bool atEnd() const { return m_at == m_end; }
  bool number(ScalarType type, float& value) {
    if (!has(sizeOf(type)))
      return false;
    value = loadFloat(type, m_at, m_swap);
    m_at += sizeOf(type);
    return true;
  }
  bool integer(ScalarType type, std::int64_t& value) {
    if (!has(sizeOf(type)))
      return false;
    value = loadInteger(type, m_at, m_swap);
    m_at += sizeOf(type);
    return true;
  }
  bool skip(ScalarType type, std::uint64_t count) {
    if (count > atMost(type))
      return false;
    m_at += count * sizeOf(type);
    return true;
  }
  /// Returns how many values of the type can still follow: a count above it is a lie.
  std::uint64_t atMost(ScalarType type) const { return std::uint64_t(m_end - m_at) / sizeOf(type); }
  void beginRecord() {}
  void endRecord() {}

 private:
  bool has(std::size_t bytes) const { return std::size_t(m_end - m_at) >= bytes; }
  const char* m_at;
  const char* m_end;
  bool m_swap;
};

/// Reads values as text, separated by blanks and line ends.
class TextValues {
 public:
  static constexpr bool text = true;
  TextValues(const char* at, const char* end) : m_cursor(at, end) {}

  const char* at() const { return m_cursor.at(); }
  bool atEnd() const { return m_cursor.atEnd(); }
  bool number(ScalarType, float& value) {
    m_cursor.skipSpace();
    return m_cursor.number(value);
  }
  bool integer(ScalarType, std::int64_t& value) {
    m_cursor.skipSpace();
    if (m_cursor.integer(value))
      return true;
    double real = 0.0;
    if (!m_cursor.number(real))
      return false;
    value = wholeNumber(real);
    return true;
  }
  bool skip(ScalarType, std::uint64_t count) {
    for (; count > 0; --count) {
      m_cursor.skipSpace();
      if (m_cursor.word().empty())
        return false;
    }
    return true;
  }
  std::uint64_t atMost(ScalarType) const {
    return (std::uint64_t(m_cursor.end() - m_cursor.at()) + 1) / 2;
  }
  /// Begins a record, which is a line; some writers put comments between records.
  void beginRecord() {
    m_cursor.skipSpace();
    while (m_cursor.peek() == 'c' && m_cursor.peekWord() == "comment") {
      m_cursor.skipLine();
      m_cursor.skipSpace();
    }
  }
  void endRecord() { m_cursor.skipLine(); }

 private:
  TextCursor m_cursor;
};

}  // namespace sline::model
