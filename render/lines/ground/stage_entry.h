// SPDX-License-Identifier: Apache-2.0
// Decides when each part of a line enters its stage (METHOD §7 ▲): lines come by length as well as
// by width, and the drawn length grows evenly with T.
#pragma once

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <vector>

#include "render/lines/ground/segments.h"

namespace sline::render {

/// Ranks values by the share of length below them, from a histogram of lengths over values.
class Ranking {
 public:
  Ranking(float low, float high) : m_low(low), m_scale(high > low ? bins / (high - low) : 0.0f) {}

  /// Counts a length at that value.
  void add(float value, float length) { m_below[std::size_t(place(value)) + 1] += length; }
  void close() {
    for (std::size_t i = 1; i < m_below.size(); ++i)
      m_below[i] += m_below[i - 1];
  }
  /// Returns the share of all length that lies below the value, 0 … 1. `close` must be called
  /// before.
  float rank(float value) const {
    const float at = place(value);
    const std::size_t bin = std::size_t(at);
    const float total = m_below.back();
    if (!(total > 0.0f))
      return 0.0f;
    return (m_below[bin] + (at - float(bin)) * (m_below[bin + 1] - m_below[bin])) / total;
  }

 private:
  static constexpr int bins = 256;
  float place(float value) const {
    return std::clamp((value - m_low) * m_scale, 0.0f, float(bins) - 1e-3f);
  }

  float m_low;
  float m_scale;
  std::array<float, bins + 1> m_below{};
};

/// Replaces the segments' entries by their rank. Before any time T a share T of the length for
/// which `counts` is true has then entered.
template <class Counts>
void replaceByRank(std::vector<Segment>& segments, const Counts& counts) {
  if (segments.empty())
    return;
  float low = segments.front().entryA;
  float high = low;
  for (const Segment& s : segments) {
    low = std::min({low, s.entryA, s.entryB});
    high = std::max({high, s.entryA, s.entryB});
  }
  Ranking ranking(low, high);
  for (const Segment& s : segments)
    if (counts(s))
      ranking.add(0.5f * (s.entryA + s.entryB), glm::distance(s.a, s.b));
  ranking.close();
  for (Segment& s : segments) {
    s.entryA = ranking.rank(s.entryA);
    s.entryB = ranking.rank(s.entryB);
  }
}
/// Returns how far a line of that rank has entered at T, 0 … 1; the mean over all ranks is T.
float entered(float t, float rank);

}  // namespace sline::render
