// SPDX-License-Identifier: Apache-2.0
// Describes a command as its `--help` does, as a value from which man pages and completions are
// written.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace sline::cli {

enum class Completes { nothing, choices, files, folders };

struct TableOption {
  std::vector<std::string> names;  ///< with their dashes, short ones first; a positional's own name
  std::string value;  ///< the type's name, for a person: "FILE.png", "auto|off|N"; may be empty
  std::string about;  ///< what `--help` says after the names: type, default, needs, excludes
  std::string help;
  std::string group;
  std::vector<std::string> choices;
  Completes completes = Completes::nothing;
  bool positional = false;
  bool takesValue = false;
  bool repeated = false;
};

struct CommandTable {
  std::string name;   ///< "render"; "sline" for the program itself
  std::string usage;  ///< "sline render [OPTIONS] INPUT..."
  std::string description;
  std::string footer;
  std::vector<TableOption> options;  ///< as they were declared; hidden ones are left out
};

/// Reads the declared options of a command, those in its option groups too. `title` is the
/// command's name.
CommandTable tableOf(const CLI::App& command, const std::string& title);

/// Returns the sub-commands that `--help` lists, as they were declared.
std::vector<const CLI::App*> shownCommands(const CLI::App& program);

}  // namespace sline::cli
