// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include "app/cli/label_flags.h"

namespace sline::cli {

/// Declares the flags of `LabelFlags` on a sub-command.
inline void addLabelOptions(CLI::App& command, LabelFlags& flags) {
  command
      .add_option("--labels", flags.mode,
                  "The scene's annotations in the picture: on with their texts, numbers with "
                  "numbered badges (their key goes to standard output), blank with empty lines "
                  "for a test, or off. Anatomical views leave room for them at both sides")
      ->type_name("on|off|numbers|blank")
      ->capture_default_str();
  command
      .add_option("--language", flags.language,
                  "The language of labels, as in de or la; where one has no text in it, the "
                  "scene's own")
      ->type_name("TAG");
  command
      .add_option("--label-size", flags.points,
                  "Of labels' letters, in points of a picture 190.5 mm (720 pixels at 96 per "
                  "inch) high, whatever its size in pixels")
      ->type_name("PT")
      ->check(CLI::Range(4.0, 48.0))
      ->capture_default_str();
}

}  // namespace sline::cli
