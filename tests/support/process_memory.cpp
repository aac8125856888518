// SPDX-License-Identifier: Apache-2.0
#include "tests/support/process_memory.h"

#include <sys/resource.h>

#include <fstream>
#include <sstream>
#include <string>

namespace sline::test {

namespace {
double statusMiB(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with(key)) {
      std::istringstream rest(line.substr(key.size()));
      double kibibytes = 0.0;
      rest >> kibibytes;
      return kibibytes / 1024.0;
    }
  return 0.0;
}
}  // namespace

double residentMiB() {
  return statusMiB("VmRSS:");
}

double peakResidentMiB() {
  return statusMiB("VmHWM:");
}

double childrenPeakMiB() {
  rusage used{};
  return getrusage(RUSAGE_CHILDREN, &used) == 0 ? double(used.ru_maxrss) / 1024.0 : 0.0;
}

void resetPeak() {
  std::ofstream("/proc/self/clear_refs") << "5";
}

}  // namespace sline::test
