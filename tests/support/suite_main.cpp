// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include "tests/support/suite.h"

namespace sline::test {
namespace {
std::map<std::string, RunSuite>& suites() {
  static std::map<std::string, RunSuite> all;
  return all;
}
}  // namespace

bool enrol(const char* sourceFile, RunSuite run) {
  const bool fresh =
      suites().emplace(std::filesystem::path(sourceFile).stem().string(), run).second;
  if (!fresh)
    std::cerr << "Two suites are called as " << sourceFile << " is.\n";
  return fresh;
}

}  // namespace sline::test

int main(int argc, char** argv) {
  const auto& suites = sline::test::suites();
  const auto found = argc < 2 ? suites.end() : suites.find(argv[1]);
  if (found == suites.end()) {
    std::cerr << "usage: " << argv[0] << " SUITE [arguments of QtTest]\nSuites:\n";
    for (const auto& [name, run] : suites)
      std::cerr << "  " << name << '\n';
    return 2;
  }
  qputenv("SLINE_PAGE", SLINE_TEST_PAGE);
  // What does not come to an end is ended by ctest, which knows how long a suite takes.
  if (!qEnvironmentVariableIsSet("QTEST_FUNCTION_TIMEOUT"))
    qputenv("QTEST_FUNCTION_TIMEOUT", "2000000000");
  std::vector<char*> arguments(argv, argv + argc + 1);
  arguments.erase(arguments.begin() + 1);
  return found->second(argc - 1, arguments.data());
}
