// SPDX-License-Identifier: Apache-2.0
#include "model/import/dicom/guarded_stream.h"

#include <algorithm>
#include <cstring>

namespace sline::model {

namespace {

/// Standard objects nest six deep; this is room for a few hundred levels, and an eighth of what
/// threads have.
constexpr std::size_t mostStack = std::size_t(1) << 20;
/// About five million elements: the largest plans have a tenth of that.
constexpr std::size_t mostReads = 20'000'000;

/// An address in the frame of whoever calls.
[[gnu::noinline]] const char* stackHere() {
  return static_cast<const char*>(__builtin_frame_address(0));
}

}  // namespace

GuardedBytes::GuardedBytes(std::string_view bytes) : m_bytes(bytes), m_stack(stackHere()) {}

void GuardedBytes::watch() {
  const char* here = stackHere();
  const auto used = std::size_t(here < m_stack ? m_stack - here : here - m_stack);
  if (used > mostStack)
    m_fault = Fault::nestedTooDeep;
  else if (++m_reads > mostReads)
    m_fault = Fault::tooManyElements;
}

offile_off_t GuardedBytes::read(void* buffer, offile_off_t size) {
  watch();
  const offile_off_t count = std::clamp<offile_off_t>(size, 0, avail());
  if (count > 0)
    std::memcpy(buffer, m_bytes.data() + m_at, std::size_t(count));
  m_at += std::size_t(count);
  return count;
}

offile_off_t GuardedBytes::skip(offile_off_t size) {
  watch();
  const offile_off_t count = std::clamp<offile_off_t>(size, 0, avail());
  m_at += std::size_t(count);
  return count;
}

void GuardedBytes::putback(offile_off_t size) {
  if (size < 0 || std::size_t(size) > m_at)
    m_fault = Fault::putBackTooFar;
  else
    m_at -= std::size_t(size);
}

}  // namespace sline::model
