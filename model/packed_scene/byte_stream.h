// SPDX-License-Identifier: Apache-2.0
// Writes and reads numbers as bytes, the lowest first.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "model/base/number_codes.h"

namespace sline::model::packing {

class ByteWriter {
 public:
  void word(std::uint32_t value) {
    m_bytes.resize(m_bytes.size() + 4);
    putWord(m_bytes.data() + m_bytes.size() - 4, value);
  }
  void real(float value) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    word(bits);
  }
  void block(std::string_view bytes) {
    word(std::uint32_t(bytes.size()));
    m_bytes += bytes;
  }
  void raw(std::string_view bytes) { m_bytes += bytes; }
  std::string take() { return std::move(m_bytes); }

 private:
  std::string m_bytes;
};

/// Adds a number in as few bytes as it needs, seven bits each.
inline void putShort(std::string& bytes, std::uint32_t value) {
  for (; value >= 0x80u; value >>= 7)
    bytes += char(value | 0x80u);
  bytes += char(value);
}

/// Reads bytes that are not trusted. After the first fault all that it returns is zero or empty.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : m_rest(bytes) {}
  bool failed() const { return m_failed; }
  bool atEnd() const { return m_rest.empty(); }

  std::string_view raw(std::size_t count) {
    if (count > m_rest.size()) {
      fail();
      return {};
    }
    const std::string_view bytes = m_rest.substr(0, count);
    m_rest.remove_prefix(count);
    return bytes;
  }
  std::uint32_t word() {
    const std::string_view bytes = raw(4);
    return bytes.size() == 4 ? wordAt(bytes, 0) : 0u;
  }
  float real() {
    const std::uint32_t bits = word();
    float value = 0.0f;
    std::memcpy(&value, &bits, sizeof value);
    return value;
  }
  std::uint8_t byte() {
    const std::string_view one = raw(1);
    return one.empty() ? std::uint8_t(0) : std::uint8_t(one[0]);
  }
  std::uint32_t shortWord() {
    std::uint32_t value = 0;
    for (int shift = 0; shift < 35; shift += 7) {
      const std::uint8_t part = byte();
      value |= std::uint32_t(part & 0x7fu) << shift;
      if (part < 0x80u)
        return value;
    }
    fail();
    return 0;
  }
  std::string_view block() { return raw(word()); }
  void fail() {
    m_failed = true;
    m_rest = {};
  }

 private:
  std::string_view m_rest;
  bool m_failed = false;
};

}  // namespace sline::model::packing
