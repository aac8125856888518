// SPDX-License-Identifier: Apache-2.0
#include "app/cli/arguments.h"

#include <set>

namespace sline::cli {

namespace {
/// A dash and something that is no number.
bool isOption(const std::string& argument) {
  return argument.size() > 1 && argument[0] == '-' && argument[1] != '.' &&
         (argument[1] < '0' || argument[1] > '9');
}
}  // namespace

std::vector<std::string> withInputsFirst(const std::vector<std::string>& arguments,
                                         const std::function<bool(const std::string&)>& exists) {
  if (arguments.empty())
    return arguments;
  std::vector<std::string> inputs;
  std::vector<std::string> others;
  std::string option;
  std::size_t values = 0;
  for (std::size_t i = 1; i < arguments.size(); ++i) {
    const std::string& argument = arguments[i];
    if (isOption(argument)) {
      option = argument;
      values = 0;
      others.push_back(argument);
      continue;
    }
    static const std::set<std::string> assigning{"--gamma", "--pen",        "--hatch-density",
                                                 "--color", "--hatch-tone", "--colour"};
    const bool assigns = assigning.contains(option);
    const bool isInput = (assigns && values > 0 && argument.find('=') == std::string::npos) ||
                         (option == "--only" && values > 0 && exists(argument));
    ++values;
    (isInput ? inputs : others).push_back(argument);
  }
  std::vector<std::string> result{arguments.front()};
  result.insert(result.end(), inputs.begin(), inputs.end());
  result.insert(result.end(), others.begin(), others.end());
  return result;
}

}  // namespace sline::cli
