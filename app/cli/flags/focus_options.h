// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include "app/cli/flags/focus_flags.h"
#include "app/cli/flags/option_kinds.h"

namespace sline::cli {

/// Declares the flags of `FocusFlags` on a sub-command.
inline void addFocusOptions(CLI::App& command, FocusFlags& flags) {
  many(command.add_option(
           "--focus", flags.names,
           "Draws these structures and groups in detail and everything else by what it is "
           "to them: vessels that come to them, neighbours, shells that hide them, the "
           "rest. What --gamma and --fill say wins; may be given again"))
      ->type_name("NAME[,NAME...]");
  command
      .add_option_function<double>(
          "--context",
          [&flags](const double& amount) {
            flags.context = amount;
            flags.contextGiven = true;
          },
          "How much is drawn around the focus: 0 nothing … 1 everything clearly there")
      ->type_name("0..1")
      ->default_str("0.5");
  command
      .add_option(
          "--context-from", flags.from,
          "What hides the focus is judged from the picture's camera alone, or from all round "
          "for pictures that turn it")
      ->type_name("camera|around")
      ->capture_default_str();
  command
      .add_option("--focus-near", flags.near,
                  "Draws everything by how near it is to these structures, or to a place in LPS "
                  "millimetres: shaded there, then hatched, in the end silhouettes; what lies "
                  "before it becomes outlines")
      ->type_name("NAME[,NAME...]|X,Y,Z");
  command
      .add_option_function<double>(
          "--falloff", [&flags](const double& millimetres) { flags.falloff = millimetres; },
          "From what distance on --focus-near draws silhouettes, in mm; else what suits the scene")
      ->type_name("MM");
}

}  // namespace sline::cli
