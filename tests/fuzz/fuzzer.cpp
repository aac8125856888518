// SPDX-License-Identifier: Apache-2.0
// Runs `sline-fuzz`, libFuzzer's program for all harnesses; the variable SLINE_HARNESS names the
// one.
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "tests/fuzz/harnesses.h"

namespace {
const sline::fuzz::Harness& chosen() {
  const char* const name = std::getenv("SLINE_HARNESS");
  if (const sline::fuzz::Harness* harness = sline::fuzz::harnessNamed(name ? name : ""))
    return *harness;
  // The list is for run.sh, one name to the line.
  for (const sline::fuzz::Harness& harness : sline::fuzz::harnesses())
    std::printf("%.*s\n", int(harness.name.size()), harness.name.data());
  std::exit(2);
}
}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const sline::fuzz::Harness& harness = chosen();
  const std::string fault = harness.run({reinterpret_cast<const char*>(data), size});
  if (!fault.empty()) {
    std::fprintf(stderr, "SLINE FAULT: %s\n", fault.c_str());
    std::abort();
  }
  return 0;
}

extern "C" int LLVMFuzzerInitialize(int* /*argc*/, char*** /*argv*/) {
  chosen();
  return 0;
}
