// SPDX-License-Identifier: Apache-2.0
#include "render/export/motion/rank_stretches.h"

#include <algorithm>
#include <cmath>

namespace sline::render {

namespace {

/// Returns what a frame costs with that rank: of two labels in each other's way, one is left out.
double costOf(const std::optional<FrameRank>& now, std::size_t rank) {
  if (!now)
    return 0.0;
  const double off = std::abs(double(now->rank) - double(rank));
  return now->weight * std::min(0.5 * off, 1.0);
}

/// Returns the rank in each frame for which the sum of costs and changes is least (after Viterbi).
std::vector<std::size_t> cheapestRanks(const std::vector<std::optional<FrameRank>>& ranks,
                                       double price) {
  std::size_t most = 0;
  for (const std::optional<FrameRank>& now : ranks)
    most = std::max(most, now ? now->rank : 0);
  std::vector<double> costs(most + 1, 0.0);
  std::vector<std::vector<std::size_t>> from;
  from.reserve(ranks.size());
  for (const std::optional<FrameRank>& now : ranks) {
    const auto best = std::size_t(std::min_element(costs.begin(), costs.end()) - costs.begin());
    const double change = costs[best] + price;
    std::vector<std::size_t>& before = from.emplace_back(most + 1);
    for (std::size_t rank = 0; rank <= most; ++rank) {
      before[rank] = change < costs[rank] ? best : rank;
      costs[rank] = std::min(change, costs[rank]) + costOf(now, rank);
    }
  }
  auto rank = std::size_t(std::min_element(costs.begin(), costs.end()) - costs.begin());
  std::vector<std::size_t> kept(ranks.size());
  for (std::size_t t = ranks.size(); t-- > 0;) {
    kept[t] = rank;
    rank = from[t][rank];
  }
  return kept;
}

}  // namespace

std::vector<Presence> rankStretches(const std::vector<std::optional<FrameRank>>& ranks,
                                    const Film& film) {
  const std::size_t count = ranks.size();
  const double second = double(film.framesPerSecond());
  // A film that loops is passed three times, so that the second has others before and after it.
  std::vector<std::optional<FrameRank>> passed = ranks;
  for (int pass = 1; film.loops() && pass < 3; ++pass)
    passed.insert(passed.end(), ranks.begin(), ranks.end());
  std::vector<std::size_t> kept = cheapestRanks(passed, second);
  if (film.loops())
    kept = {kept.begin() + std::ptrdiff_t(count), kept.begin() + std::ptrdiff_t(2 * count)};
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
