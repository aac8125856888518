// SPDX-License-Identifier: Apache-2.0
#include "render/strokes/stage_entry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "render/lines/coarse_depth.h"
#include "render/lines/view_scale.h"

namespace sline::render {

namespace {
// Share of all ranks that are on their way in at the same time.
constexpr float softness = 0.5f;
// Share of every line's growth that does not wait for its rank: where all lines of some ranks are
// hidden or short the picture would stand still while the front passes over them.
constexpr float plainGrowth = 0.3f;

/// The value below which a share of the length lies, by a histogram.
class Ranking {
 public:
  Ranking(float low, float high) : m_low(low), m_scale(high > low ? bins / (high - low) : 0.0f) {}

  void add(float value, float length) { m_below[std::size_t(place(value)) + 1] += length; }
  void close() {
    for (std::size_t i = 1; i < m_below.size(); ++i)
      m_below[i] += m_below[i - 1];
  }
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
}  // namespace

void rankContours(std::vector<Segment>& contours, const model::Surface& surface,
                  const model::Camera& camera) {
  const ViewScale scale(camera);
  for (Segment& s : contours) {
    s.entryA = scale.project(s.a).distanceMm;
    s.entryB = scale.project(s.b).distanceMm;
  }
  const CoarseDepth depth(surface, camera);
  const auto counts = [&](const Segment& s) {
    const glm::vec3 middle = 0.5f * (s.a + s.b);
    return depth.surrounds(middle, s.normalA) && depth.sees(middle);
  };
  replaceByRank(contours, counts);
}

void rankSuggestive(std::vector<Segment>& suggestive) {
  replaceByRank(suggestive, [](const Segment&) { return true; });
}

// A front of width `softness` passes over the ranks 0 … 1 and has let in u²/2s, then u − s/2, then
// all but (1 + s − u)²/2s of them when it stands at u. The inverse says where it stands at T,
// so that the mean over the ranks is T; and so it is with any share of growing by T itself.
float entered(float t, float rank) {
  constexpr float s = softness;
  if (t <= 0.0f)
    return 0.0f;
  if (t >= 1.0f)
    return 1.0f;
  float front = t + 0.5f * s;
  if (t < 0.5f * s)
    front = std::sqrt(2.0f * s * t);
  else if (t > 1.0f - 0.5f * s)
    front = 1.0f + s - std::sqrt(2.0f * s * (1.0f - t));
  return plainGrowth * t + (1.0f - plainGrowth) * std::clamp((front - rank) / s, 0.0f, 1.0f);
}

}  // namespace sline::render
