// SPDX-License-Identifier: Apache-2.0
// Runs the `sline` program: line illustrations of anatomy without a display.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <new>

#include "app/cli/commands/command.h"
#include "app/cli/flags/arguments.h"
#include "app/cli/flags/option_kinds.h"
#include "model/disk/process.h"

namespace {

using sline::cli::Exit;

constexpr const char* description =
    "Sline turns segmented anatomy into line drawings.\n"
    "One number, gamma, sets how each structure is drawn: 0 silhouette, 1 contours, 2 suggestive\n"
    "contours, 3 hatching, 4 with shading, 5 shaded surface. Positions are millimetres in the\n"
    "patient frame LPS (+x to the patient's left, +y to the back, +z to the head).";
constexpr const char* footer =
    "Exit codes: 0 done (parts that are missing or broken are left out, with a warning);\n"
    "1 nothing could be read, drawn or written; 2 wrong use.\n"
    "`sline COMMAND --help` explains a command.";

/// Returns the exit code, and prints a message if standard output could not be written.
int exitCodeAfterOutput(int code) {
  std::cout.flush();
  const bool told = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
  if (told && std::cout.good())
    return code;
  sline::cli::complain({.reason = "standard output cannot be written",
                        .remedy = "See that it is open and its disk has space"},
                       Exit::failed);
  return code == int(Exit::done) ? int(Exit::failed) : code;
}

/// Returns the sub-command that the arguments begin with, or null.
const CLI::App* commandOf(const CLI::App& program, const std::vector<std::string>& arguments) {
  const auto commands = program.get_subcommands([&arguments](const CLI::App* each) {
    return !arguments.empty() && each->get_name() == arguments.front();
  });
  return commands.empty() ? nullptr : commands.front();
}

std::vector<std::string> inputsFirst(const CLI::App* command,
                                     const std::vector<std::string>& arguments) {
  return sline::cli::withInputsFirst(
      arguments, {.valuesOf =
                      [command](const std::string& option) {
                        return command ? sline::cli::valuesOf(*command, option)
                                       : sline::cli::Values::one;
                      },
                  .exists =
                      [](const std::string& path) {
                        std::error_code unknown;  // a name too long for a path is no path
                        return std::filesystem::exists(path, unknown);
                      }});
}

int run(int argc, char** argv) {
  CLI::App program(description, "sline");
  program.footer(footer);
  program.set_version_flag("--version", "sline " SLINE_VERSION);
  program.require_subcommand(1);
  program.get_formatter()->column_width(34);

  Exit exit = Exit::done;
  sline::cli::addRender(program, exit);
  sline::cli::addExport(program, exit,
                        [](const std::string& message) { sline::cli::warn(message); });
  sline::cli::addProof(program, exit);
  sline::cli::addJobs(program, exit);
  sline::cli::addCompare(program, exit);
  sline::cli::addCompose(program, exit);
  sline::cli::addLines(program, exit);
  sline::cli::addCurvature(program, exit);
  sline::cli::addInfo(program, exit);
  sline::cli::addImport(program, exit);
  sline::cli::addPockets(program, exit);
  sline::cli::addReload(program, exit);
  sline::cli::addView(program, exit);
  sline::cli::addAnnotate(program, exit);
  sline::cli::addDescribe(program, exit);
  sline::cli::addCredit(program, exit);
  sline::cli::addDemo(program, exit);
  sline::cli::addRamp(program, exit);
  sline::cli::addSteadiness(program, exit);
  sline::cli::addDemoPictures(program, exit);
  sline::cli::addManual(program, exit);
  try {
    const std::vector<std::string> given{argv + std::min(argc, 1), argv + argc};
    const CLI::App* command = commandOf(program, given);
    if (const std::string wrong = command ? sline::cli::valueMissing(*command, given) : "";
        !wrong.empty()) {
      std::cerr << "sline: " << wrong << '\n';
      return int(Exit::wrongUse);
    }
    std::vector<std::string> arguments = inputsFirst(command, given);
    // CLI11 takes the arguments from the last to the first.
    std::reverse(arguments.begin(), arguments.end());
    program.parse(arguments);
  } catch (const CLI::ParseError& message) {
    return program.exit(message) == 0 ? int(Exit::done) : int(Exit::wrongUse);
  }
  return int(exit);
}

}  // namespace

int main(int argc, char** argv) {
  sline::model::keepStandardStreams();
  try {
    return exitCodeAfterOutput(run(argc, argv));
  } catch (const std::bad_alloc&) {
    std::cerr << "sline: there is not enough memory. Close other programs or draw fewer parts.\n";
  } catch (const std::exception& failure) {
    std::cerr << "sline: a library failed: " << failure.what() << ".\n";
  }
  return int(Exit::failed);
}
