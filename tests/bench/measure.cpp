// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/measure.h"

#include <algorithm>
#include <fstream>
#include <sstream>

namespace sline::bench {

namespace {
double statusKiB(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with(key)) {
      std::istringstream rest(line.substr(key.size()));
      double value = 0.0;
      rest >> value;
      return value;
    }
  return 0.0;
}
}  // namespace

Spread spreadOf(std::vector<double> milliseconds) {
  if (milliseconds.empty())
    return {};
  std::sort(milliseconds.begin(), milliseconds.end());
  const std::size_t n = milliseconds.size();
  return {.median = milliseconds[n / 2], .p95 = milliseconds[std::min(n - 1, n * 95 / 100)]};
}

double residentMiB() {
  return statusKiB("VmRSS:") / 1024.0;
}

double peakResidentMiB() {
  return statusKiB("VmHWM:") / 1024.0;
}

void resetPeak() {
  std::ofstream("/proc/self/clear_refs") << "5";
}

}  // namespace sline::bench
