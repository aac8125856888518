// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include "app/cli/commands/command.h"
#include "app/cli/flags/measure_flags.h"

namespace sline::cli {

/// Declares the flags of `MeasureFlags` on a sub-command.
inline void addMeasureOptions(CLI::App& command, MeasureFlags& flags) {
  command.add_option("INPUT", flags.input.inputs, inputHelp)->required();
  command.add_flag("--verbose", flags.input.verbose, verboseHelp);
  CLI::Option* structure =
      command
          .add_option("--structure", flags.structures,
                      "The structure to look at, alone, or each in a group; may be given again")
          ->take_all()
          ->type_size(1)
          ->expected(1)
          ->allow_extra_args(false)
          ->type_name("NAME");
  command.add_flag("--all", flags.all, "Every structure, one after the other")->excludes(structure);
  CLI::Option* view = command
                          .add_option("--view", flags.view,
                                      "anterior, posterior, left, right, superior or inferior, "
                                      "fitted to the structure; or a saved view of the scene")
                          ->type_name("NAME")
                          ->capture_default_str();
  command.add_option("--camera", flags.cameraFile, "A camera as `sline render` takes it")
      ->type_name("FILE.json")
      ->excludes(view);
  command.add_option("--size", flags.size, "Width and height in pixels, 16 to 20000 each")
      ->type_name("WxH")
      ->capture_default_str();
  command.add_flag("--json", flags.json, "For programs: one JSON object on standard output");
  command.add_flag("--check", flags.check, "Exit code 1 where a rule is broken");
  command.add_option("--smooth", flags.input.smooth, smoothHelp)
      ->type_name("auto|off|N")
      ->default_str("auto");
  addFrame(command, flags.input);
  addTogether(command, flags.input);
}

}  // namespace sline::cli
