// SPDX-License-Identifier: Apache-2.0
// Chooses for each frame of a film so that the sum of what choices and changes cost is least
// (Viterbi 1967).
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace sline::render {

/// Returns the choice in each of `count` frames, of so many choices. costAt(frame, choice) is what
/// one costs there, changeAt(frame, from, to) what it costs to go over to another one; of equal
/// sums it is the one that stays. In a film that loops, its end goes over to its beginning.
template <class CostAt, class ChangeAt>
std::vector<std::size_t> leastCostly(std::size_t count, std::size_t choices, bool loops,
                                     const CostAt& costAt, const ChangeAt& changeAt) {
  // A film that loops is passed three times, so that the second has others before and after it.
  const std::size_t passed = loops ? 3 * count : count;
  std::vector<double> costs(choices, 0.0);
  std::vector<std::vector<std::size_t>> from(passed, std::vector<std::size_t>(choices));
  for (std::size_t t = 0; t < passed; ++t) {
    std::vector<double> now = costs;
    for (std::size_t to = 0; to < choices; ++to) {
      from[t][to] = to;
      for (std::size_t was = 0; was < choices; ++was) {
        if (was == to)
          continue;
        const double cost = costs[was] + changeAt(t % count, was, to);
        if (cost < now[to]) {
          now[to] = cost;
          from[t][to] = was;
        }
      }
      now[to] += costAt(t % count, to);
    }
    costs.swap(now);
  }
  auto choice = std::size_t(std::min_element(costs.begin(), costs.end()) - costs.begin());
  std::vector<std::size_t> kept(count);
  const std::size_t first = loops ? count : 0;
  for (std::size_t t = passed; t-- > first;) {
    if (t < first + count)
      kept[t - first] = choice;
    choice = from[t][choice];
  }
  return kept;
}

}  // namespace sline::render
