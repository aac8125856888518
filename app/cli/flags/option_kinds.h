// SPDX-License-Identifier: Apache-2.0
// Holds what options of all sub-commands have in common: how many values they take, and within what
// range.
#pragma once

#include <CLI/CLI.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "app/cli/flags/arguments.h"
#include "model/base/units.h"

namespace sline::cli {

/// Declares that an option takes several values and may be given again.
inline CLI::Option* many(CLI::Option* option) {
  return option->take_all()->type_size(1)->expected(1, CLI::detail::expected_max_vector_size);
}

/// Returns how many values the sub-command's option takes as it was declared; its type's name marks
/// assignments. An unknown option takes one.
inline Values valuesOf(const CLI::App& command, const std::string& option) {
  const CLI::Option* declared = command.get_option_no_throw(option);
  if (!declared || declared->get_items_expected_max() <= 1)
    return Values::one;
  return declared->get_type_name().find('=') == std::string::npos ? Values::several
                                                                  : Values::assignments;
}

/// Returns what is wrong where an option that needs a value is followed by another of the
/// sub-command's options, which would be taken for the value; empty if nothing is.
inline std::string valueMissing(const CLI::App& command,
                                const std::vector<std::string>& arguments) {
  for (std::size_t i = 0; i + 1 < arguments.size(); ++i) {
    const CLI::Option* asked = command.get_option_no_throw(arguments[i]);
    const std::string& next = arguments[i + 1];
    if (!asked || asked->get_items_expected_min() < 1 || next.rfind("-", 0) != 0 ||
        !command.get_option_no_throw(next.substr(0, next.find('='))))
      continue;
    return arguments[i] + " needs a value (" + asked->get_type_name() + "), and " + next +
           " follows it. See --help.";
  }
  return {};
}

/// Checks for a number from `low` to `high`; "nan" is refused.
template <class Number>
CLI::Validator within(Number low, Number high) {
  std::ostringstream limits;
  limits << low << " to " << high;
  return {[low, high, right = limits.str()](std::string& text) {
            Number value{};
            if (CLI::detail::lexical_cast(text, value) && value >= low && value <= high)
              return std::string();
            return text + " is no number in the range " + right;
          },
          CLI::Range(low, high).get_description()};
}

/// Checks numbers the same way, typed as plain numbers whatever the field's type.
template <class Number>
CLI::Validator within(const Limits<Number>& limits) {
  return within(double(limits.low), double(limits.high));
}

}  // namespace sline::cli
