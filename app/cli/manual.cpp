// SPDX-License-Identifier: Apache-2.0
// Implements `sline manual FOLDER`, which `--help` does not list: writes man pages and completions
// when the program is built, from the very options that it declares.
#include <filesystem>
#include <utility>
#include <vector>

#include "app/cli/commands/command.h"
#include "app/cli/manual/completions.h"
#include "app/cli/manual/man_page.h"
#include "app/cli/manual/option_table.h"
#include "model/disk/whole_file.h"

namespace sline::cli {

namespace {

namespace fs = std::filesystem;

struct ManualFlags {
  std::string folder;
};

ProgramTable tablesOf(const CLI::App& program) {
  ProgramTable tables{.program = tableOf(program, "sline"), .commands = {}};
  for (const CLI::App* command : shownCommands(program))
    tables.commands.push_back(tableOf(*command, "sline " + command->get_name()));
  return tables;
}

/// Returns the files by their place in the folder.
std::vector<std::pair<fs::path, std::string>> manualFiles(const ProgramTable& tables) {
  std::vector<std::pair<fs::path, std::string>> files{
      {"man1/sline.1", programPage(tables.program, tables.commands)},
      {"bash/sline", bashCompletion(tables)},
      {"zsh/_sline", zshCompletion(tables)},
      {"fish/sline.fish", fishCompletion(tables)}};
  for (const CommandTable& command : tables.commands)
    files.emplace_back("man1/sline-" + command.name + ".1", commandPage(command));
  return files;
}

Exit writeManual(const ProgramTable& tables, const fs::path& folder) {
  for (const auto& [place, text] : manualFiles(tables)) {
    const fs::path file = folder / place;
    std::error_code failed;
    fs::create_directories(file.parent_path(), failed);
    if (failed)
      return complain({.file = file.parent_path().string(), .reason = failed.message()},
                      Exit::failed);
    if (const Status written = model::writeText(file, text); !written.ok())
      return complain(written.error(), Exit::failed);
  }
  return Exit::done;
}

}  // namespace

void addManual(CLI::App& program, Exit& exit) {
  addCommand<ManualFlags>(
      program, exit, {"manual", "Write man pages and completions"},
      [](CLI::App& command, ManualFlags& flags) {
        command.group("");
        command.add_option("FOLDER", flags.folder, "Where they are written")->required();
      },
      [&program](const ManualFlags& flags) {
        return writeManual(tablesOf(program), flags.folder);
      });
}

}  // namespace sline::cli
