// SPDX-License-Identifier: Apache-2.0
#include "render/export/motion/rank_stretches.h"

#include <algorithm>
#include <cmath>

#include "render/export/motion/least_costly.h"

namespace sline::render {

namespace {

/// Returns what a frame costs with that rank: of two labels in each other's way one is left out,
/// but many that stand the other way round can still pass each other.
double costOf(const std::optional<FrameRank>& now, std::size_t rank) {
  constexpr double inTheWay = 0.3;
  if (!now)
    return 0.0;
  const double off = std::abs(double(now->rank) - double(rank));
  return now->weight * std::min(inTheWay * off, 1.0);
}

}  // namespace

std::vector<Presence> rankStretches(const std::vector<std::optional<FrameRank>>& ranks,
                                    const Film& film) {
  const std::size_t count = ranks.size();
  const double second = double(film.framesPerSecond());
  std::size_t most = 0;
  for (const std::optional<FrameRank>& now : ranks)
    most = std::max(most, now ? now->rank : 0);
  const std::vector<std::size_t> kept = leastCostly(
      count, most + 1, film.loops(),
      [&](std::size_t t, std::size_t rank) { return costOf(ranks[t], rank); },
      [second](std::size_t, std::size_t, std::size_t) { return second; });
  std::vector<std::size_t> changes;
  for (std::size_t t = film.loops() ? 0 : 1; t < count; ++t)
    if (kept[t] != kept[(t + count - 1) % count])
      changes.push_back(t);
  std::vector<Presence> stretches(
      std::max<std::size_t>(film.loops() ? changes.size() : changes.size() + 1, 1),
      Presence(count));
  const auto half = std::size_t(std::ceil(0.5 * second));
  for (std::size_t t = 0; t < count; ++t) {
    const bool near = std::any_of(changes.begin(), changes.end(), [&](std::size_t change) {
      const std::size_t away = (t + count - change) % count;
      return (t >= change || film.loops()) ? away < half || away >= count - half
                                           : change - t <= half;
    });
    const auto before =
        std::size_t(std::upper_bound(changes.begin(), changes.end(), t) - changes.begin());
    stretches[before % stretches.size()][t] = ranks[t].has_value() && !near;
  }
  return stretches;
}

}  // namespace sline::render
