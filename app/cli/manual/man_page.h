// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/cli/manual/option_table.h"

namespace sline::cli {

/// Returns text as troff shows it unchanged, within a line.
std::string troffEscaped(const std::string& text);

/// Returns the page of `sline` itself, which lists the commands.
std::string programPage(const CommandTable& program, const std::vector<CommandTable>& commands);

/// Returns the page `sline-COMMAND`.
std::string commandPage(const CommandTable& command);

}  // namespace sline::cli
