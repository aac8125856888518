// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/cli/manual/option_table.h"

namespace sline::cli {

/// Holds the program's own options and those of its commands.
struct ProgramTable {
  CommandTable program;
  std::vector<CommandTable> commands;
};

/// Each returns a script that completes `sline` in that shell: commands, options, the words that an
/// option takes, and files and folders for options that take those.
std::string bashCompletion(const ProgramTable& table);
std::string zshCompletion(const ProgramTable& table);
std::string fishCompletion(const ProgramTable& table);

}  // namespace sline::cli
