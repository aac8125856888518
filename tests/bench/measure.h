// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace sline::bench {

/// Holds the median and 95th percentile of a series, in milliseconds.
struct Spread {
  double median = 0.0;
  double p95 = 0.0;
};
Spread spreadOf(std::vector<double> milliseconds);

class Stopwatch {
 public:
  double milliseconds() const {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - m_start)
        .count();
  }

 private:
  std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};

}  // namespace sline::bench
