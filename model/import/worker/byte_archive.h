// SPDX-License-Identifier: Apache-2.0
// Writes values as bytes in the machine's own order, for two programs on one machine. Each type's
// fields are listed once, in a function `visitFields(archive, value)`, which the writer and the
// reader share.
#pragma once

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace sline::model {

template <class T>
concept PlainValue = std::is_arithmetic_v<T> || std::is_enum_v<T>;

/// Is true for values that are copied byte by byte: numbers, and arrays and vectors of them.
template <class T>
inline constexpr bool copiesAsBytes = PlainValue<T>;

class ByteWriter {
 public:
  template <class... T>
  void operator()(const T&... values) {
    (put(values), ...);
  }
  std::string take() { return std::move(m_bytes); }

 private:
  template <class T>
  void put(const T& value) {
    if constexpr (copiesAsBytes<T>)
      raw(&value, sizeof(T));
    else
      visitFields(*this, const_cast<T&>(value));
  }
  void put(const std::string& text) { putAll(text); }
  void put(const std::filesystem::path& path) { put(path.string()); }
  template <class T>
  void put(const std::optional<T>& value) {
    put(std::uint8_t(value.has_value()));
    if (value)
      put(*value);
  }
  template <class T>
  void put(const std::vector<T>& values) {
    if constexpr (copiesAsBytes<T>) {
      putAll(values);
    } else {
      put(std::uint64_t(values.size()));
      for (const T& value : values)
        put(value);
    }
  }
  template <class Values>
  void putAll(const Values& values) {
    put(std::uint64_t(values.size()));
    raw(values.data(), values.size() * sizeof(*values.data()));
  }
  void raw(const void* from, std::size_t size) {
    m_bytes.append(static_cast<const char*>(from), size);
  }

  std::string m_bytes;
};

/// Reads what a ByteWriter wrote. Bytes that end early or promise more than there is leave values
/// empty and `good` false; nothing is allocated that the bytes do not hold.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : m_bytes(bytes) {}
  template <class... T>
  void operator()(T&... values) {
    (take(values), ...);
  }
  /// Tells whether all values were there, and nothing more.
  bool complete() const { return m_good && m_bytes.empty(); }
  bool good() const { return m_good; }
  void fail() { m_good = false; }

 private:
  template <class T>
  void take(T& value) {
    if constexpr (std::is_same_v<T, bool>)
      value = takeNumber<std::uint8_t>() != 0;
    else if constexpr (copiesAsBytes<T>)
      raw(&value, sizeof(T));
    else
      visitFields(*this, value);
  }
  void take(std::string& text) { takeAll(text); }
  void take(std::filesystem::path& path) {
    std::string text;
    take(text);
    path = text;
  }
  template <class T>
  void take(std::optional<T>& value) {
    if (takeNumber<std::uint8_t>() == 0)
      return value.reset();
    take(value.emplace());
  }
  template <class T>
  void take(std::vector<T>& values) {
    if constexpr (copiesAsBytes<T>) {
      takeAll(values);
    } else {
      const auto count = takeNumber<std::uint64_t>();
      // Each value takes at least one byte.
      if (count > m_bytes.size())
        return fail();
      for (std::uint64_t i = 0; i < count && m_good; ++i)
        take(values.emplace_back());
    }
  }
  template <class Values>
  void takeAll(Values& values) {
    const auto count = takeNumber<std::uint64_t>();
    if (count > m_bytes.size() / sizeof(*values.data()))
      return fail();
    values.resize(count);
    raw(values.data(), count * sizeof(*values.data()));
  }
  template <class T>
  T takeNumber() {
    T number{};
    raw(&number, sizeof(T));
    return number;
  }
  void raw(void* to, std::size_t size) {
    if (!m_good || size > m_bytes.size())
      return fail();
    if (size > 0)
      std::memcpy(to, m_bytes.data(), size);
    m_bytes.remove_prefix(size);
  }

  std::string_view m_bytes;
  bool m_good = true;
};

}  // namespace sline::model
