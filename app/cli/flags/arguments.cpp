// SPDX-License-Identifier: Apache-2.0
#include "app/cli/flags/arguments.h"

namespace sline::cli {

namespace {
/// Tells whether it is a dash followed by something that is not a number.
bool isOption(const std::string& argument) {
  return argument.size() > 1 && argument[0] == '-' && argument[1] != '.' &&
         (argument[1] < '0' || argument[1] > '9');
}
}  // namespace

std::vector<std::string> withInputsFirst(const std::vector<std::string>& arguments,
                                         const ArgumentKinds& kinds) {
  if (arguments.empty())
    return arguments;
  std::vector<std::string> inputs;
  std::vector<std::string> others;
  Values taken = Values::one;
  std::size_t values = 0;
  for (std::size_t i = 1; i < arguments.size(); ++i) {
    const std::string& argument = arguments[i];
    if (isOption(argument)) {
      const std::size_t equals = argument.find('=');
      taken = kinds.valuesOf(argument.substr(0, equals));
      values = equals == std::string::npos ? 0 : 1;
      others.push_back(argument);
      continue;
    }
    const bool assigned = argument.find('=') != std::string::npos;
    const bool isInput = values > 0 && ((taken == Values::assignments && !assigned) ||
                                        (taken == Values::several && kinds.exists(argument)));
    ++values;
    (isInput ? inputs : others).push_back(argument);
  }
  std::vector<std::string> result{arguments.front()};
  result.insert(result.end(), inputs.begin(), inputs.end());
  result.insert(result.end(), others.begin(), others.end());
  return result;
}

}  // namespace sline::cli
