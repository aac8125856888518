// SPDX-License-Identifier: Apache-2.0
#include "model/scene_file/text_delta.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "model/scene_file/journal_records.h"

namespace sline::model {

namespace {
using Lines = std::vector<std::string_view>;

Lines linesOf(std::string_view text) {
  Lines lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
    lines.push_back(text.substr(0, end));
    text.remove_prefix(end);
  }
  return lines;
}

/// Finds the way from one list of lines to another: where they part, the shortest stretch of both
/// after which they go on alike for some lines.
class LineWalk {
 public:
  LineWalk(const Lines& before, const Lines& after) : m_before(before), m_after(after) {}

  /// Returns the stretches from the places on; absent where none within reach will do.
  std::optional<std::pair<std::size_t, std::size_t>> stretchFrom(std::size_t i,
                                                                 std::size_t j) const {
    for (std::size_t both = 1; both <= reach; ++both)
      for (std::size_t out = 0; out <= both; ++out)
        if (alike(i + out, j + (both - out)))
          return std::pair{out, both - out};
    return std::nullopt;
  }

  /// Returns how many lines at the end are alike, if what is before the places is left alone.
  std::size_t tailFrom(std::size_t i, std::size_t j) const {
    std::size_t count = 0;
    const std::size_t most = std::min(m_before.size() - i, m_after.size() - j);
    while (count < most &&
           m_before[m_before.size() - 1 - count] == m_after[m_after.size() - 1 - count])
      ++count;
    return count;
  }

 private:
  static constexpr std::size_t reach = 600;
  static constexpr std::size_t enough = 2;

  bool alike(std::size_t i, std::size_t j) const {
    if (i > m_before.size() || j > m_after.size())
      return false;
    for (std::size_t k = 0; k < enough; ++k) {
      const bool endBefore = i + k == m_before.size();
      const bool endAfter = j + k == m_after.size();
      if (endBefore && endAfter)
        return true;
      if (endBefore || endAfter || m_before[i + k] != m_after[j + k])
        return false;
    }
    return true;
  }

  const Lines& m_before;
  const Lines& m_after;
};

/// Writes the row of changes; those that touch become one.
class DeltaWriter {
 public:
  void keep(std::string_view line) {
    if (m_out > 0 || !m_in.empty())
      flush();
    m_kept += line.size();
  }
  void leaveOut(std::string_view line) { m_out += line.size(); }
  void putIn(std::string_view line) { m_in += line; }
  std::string done() {
    flush();
    return std::move(m_delta);
  }

 private:
  void flush() {
    appendNumber(m_delta, std::uint32_t(m_kept));
    appendNumber(m_delta, std::uint32_t(m_out));
    appendNumber(m_delta, std::uint32_t(m_in.size()));
    m_delta += m_in;
    m_kept = m_out = 0;
    m_in.clear();
  }
  std::string m_delta;
  std::size_t m_kept = 0;
  std::size_t m_out = 0;
  std::string m_in;
};
}  // namespace

std::string textDelta(std::string_view before, std::string_view after) {
  const Lines a = linesOf(before);
  const Lines b = linesOf(after);
  const LineWalk walk(a, b);
  DeltaWriter delta;
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < a.size() || j < b.size()) {
    if (i < a.size() && j < b.size() && a[i] == b[j]) {
      delta.keep(a[i++]);
      ++j;
      continue;
    }
    auto stretch = walk.stretchFrom(i, j);
    if (!stretch) {
      const std::size_t tail = walk.tailFrom(i, j);
      stretch = {a.size() - tail - i, b.size() - tail - j};
    }
    for (const std::size_t end = i + stretch->first; i < end; ++i)
      delta.leaveOut(a[i]);
    for (const std::size_t end = j + stretch->second; j < end; ++j)
      delta.putIn(b[j]);
  }
  return delta.done();
}

std::optional<std::string> withDelta(std::string_view before, std::string_view delta) {
  std::string after;
  after.reserve(before.size() + delta.size());
  while (!delta.empty()) {
    const auto kept = takeNumber(delta);
    const auto out = takeNumber(delta);
    const auto length = takeNumber(delta);
    const auto in = length ? takeBytes(delta, *length) : std::nullopt;
    const auto keeps = in ? takeBytes(before, *kept) : std::nullopt;
    if (!keeps || !takeBytes(before, *out))
      return std::nullopt;
    after += *keeps;
    after += *in;
  }
  return after;
}

}  // namespace sline::model
