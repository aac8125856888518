// SPDX-License-Identifier: Apache-2.0
// Adds what C++20's standard library has and the one that comes with Emscripten 3.1 lacks. The
// compiler reads it before each source of the page's program (-include); nothing includes it.
#pragma once

#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <system_error>
#include <type_traits>

namespace std {

template <class To, class From>
inline To bit_cast(const From& from) {
  static_assert(sizeof(To) == sizeof(From) && is_trivially_copyable_v<To> &&
                is_trivially_copyable_v<From>);
  To to;
  memcpy(&to, &from, sizeof to);
  return to;
}

template <class T>
requires is_unbounded_array_v<T>
inline unique_ptr<T> make_unique_for_overwrite(size_t count) {
  return unique_ptr<T>(new remove_extent_t<T>[count]);
}

/// As the standard says for chars_format::general; it takes no number that is longer than any that
/// is written here.
template <class Real>
requires is_floating_point_v<Real>
inline from_chars_result from_chars(const char* first, const char* last, Real& value) {
  const string text(first, min<size_t>(size_t(last - first), 64));
  // strtod also takes blanks, a plus sign and hexadecimal numbers.
  const bool sign = !text.empty() && text[0] == '-';
  const char head = text.size() > (sign ? 1u : 0u) ? text[sign ? 1 : 0] : ' ';
  const char second = text.size() > (sign ? 2u : 1u) ? text[sign ? 2 : 1] : ' ';
  if (!((head >= '0' && head <= '9') || head == '.' || head == 'i' || head == 'n') ||
      second == 'x' || second == 'X')
    return {first, errc::invalid_argument};
  char* end = nullptr;
  const double read = strtod(text.c_str(), &end);
  if (end == text.c_str())
    return {first, errc::invalid_argument};
  value = Real(read);
  return {first + (end - text.c_str()), errc()};
}

/// Writes the fewest digits that are read as the same number.
template <class Real>
requires is_floating_point_v<Real>
inline to_chars_result to_chars(char* first, char* last, Real value) {
  char digits[40];
  int length = 0;
  for (int precision = 1; precision <= 17; ++precision) {
    length = snprintf(digits, sizeof digits, "%.*g", precision, double(value));
    if (Real(strtod(digits, nullptr)) == value)
      break;
  }
  if (length > last - first)
    return {last, errc::value_too_large};
  memcpy(first, digits, size_t(length));
  return {first + length, errc()};
}

}  // namespace std
