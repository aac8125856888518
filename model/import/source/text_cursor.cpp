// SPDX-License-Identifier: Apache-2.0
#include "model/import/source/text_cursor.h"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <limits>
#include <system_error>

namespace sline::model {

namespace {
/// Tells whether a number may end here: a number that runs into other text is not one.
bool endsNumber(const char* at, const char* end) {
  if (at == end || TextCursor::isSpace(*at))
    return true;
  return *at == '#' || *at == '\\' || *at == '\0';
}

/// Returns the value of digits that are out of range. from_chars reports overflow and underflow
/// alike; the digits themselves tell them apart.
double outOfRangeValue(std::string_view digits) {
  const std::size_t exponent = digits.find_first_of("eE");
  const bool small = exponent == std::string_view::npos
                         ? digits.find_first_of("123456789") > digits.find('.')
                         : digits.substr(exponent + 1).starts_with('-');
  return small ? 0.0 : std::numeric_limits<double>::infinity();
}

/// Skips 1.#QNAN, -1.#IND and 1.#INF, which Microsoft's runtime writes.
bool skipMicrosoftNonFinite(const char*& at, const char* end) {
  if (at == end || *at != '#' || end - at < 4 || (at[1] != 'I' && at[1] != 'Q' && at[1] != 'S'))
    return false;
  while (at != end && !TextCursor::isSpace(*at))
    ++at;
  return true;
}

template <class T>
const char* parseReal(const char* at, const char* end, T& value) {
  if (at != end && *at == '+' && end - at > 1 && at[1] != '-')
    ++at;
  const char* start = at;
  const std::from_chars_result result = std::from_chars(at, end, value);
  if (result.ec == std::errc::invalid_argument)
    return nullptr;
  at = result.ptr;
  if (result.ec == std::errc::result_out_of_range) {
    double wide = 0.0;
    if (std::from_chars(start, at, wide).ec != std::errc())
      wide = outOfRangeValue({start, std::size_t(at - start)});
    // A double beyond the float range becomes infinite by intent: such a vertex is left out later.
    const bool beyond = wide > double(std::numeric_limits<T>::max()) ||
                        wide < double(std::numeric_limits<T>::lowest());
    value = beyond ? std::numeric_limits<T>::infinity() : T(wide);
  }
  if (skipMicrosoftNonFinite(at, end))
    value = std::numeric_limits<T>::quiet_NaN();
  return endsNumber(at, end) ? at : nullptr;
}
}  // namespace

bool TextCursor::skipContinuation() {
  const char* next = m_at + 1;
  if (next != m_end && *next == '\r')
    ++next;
  if (next != m_end && *next == '\n')
    ++next;
  if (next == m_at + 1)
    return false;
  m_at = next;
  return true;
}

void TextCursor::skipLine() {
  const auto left = std::size_t(m_end - m_at);
  if (left == 0)
    return;
  const char* feed = static_cast<const char*>(std::memchr(m_at, '\n', left));
  const char* stop = feed ? feed : m_end;
  const char* back = static_cast<const char*>(std::memchr(m_at, '\r', std::size_t(stop - m_at)));
  if (back && back + 1 != feed)
    m_at = back + 1;
  else
    m_at = feed ? feed + 1 : m_end;
}

std::string_view TextCursor::restOfLine() {
  skipBlanks();
  const char* start = m_at;
  skipLine();
  const char* stop = m_at;
  while (stop != start && isSpace(stop[-1]))
    --stop;
  return {start, std::size_t(stop - start)};
}

std::string_view TextCursor::word() {
  const char* start = m_at;
  while (m_at != m_end && !isSpace(*m_at))
    ++m_at;
  return {start, std::size_t(m_at - start)};
}

bool TextCursor::number(float& value) {
  const char* next = parseReal(m_at, m_end, value);
  if (next)
    m_at = next;
  return next != nullptr;
}

bool TextCursor::number(double& value) {
  const char* next = parseReal(m_at, m_end, value);
  if (next)
    m_at = next;
  return next != nullptr;
}

bool TextCursor::integer(std::int64_t& value) {
  const char* at = m_at;
  if (at != m_end && *at == '+' && m_end - at > 1 && at[1] != '-')
    ++at;
  const auto [stop, code] = std::from_chars(at, m_end, value);
  if (code == std::errc::invalid_argument)
    return false;
  if (code == std::errc::result_out_of_range)
    value = *at == '-' ? std::numeric_limits<std::int64_t>::min()
                       : std::numeric_limits<std::int64_t>::max();
  const char next = stop == m_end ? ' ' : *stop;
  const bool runsOn = next == '.' || next == '-' || next == '+' || (next >= 'a' && next <= 'z') ||
                      (next >= 'A' && next <= 'Z');
  if (!runsOn)
    m_at = stop;
  return !runsOn;
}

}  // namespace sline::model
