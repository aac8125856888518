// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/measure.h"

#include <algorithm>

namespace sline::bench {

Spread spreadOf(std::vector<double> milliseconds) {
  if (milliseconds.empty())
    return {};
  std::sort(milliseconds.begin(), milliseconds.end());
  const std::size_t n = milliseconds.size();
  return {.median = milliseconds[n / 2], .p95 = milliseconds[std::min(n - 1, n * 95 / 100)]};
}

}  // namespace sline::bench
