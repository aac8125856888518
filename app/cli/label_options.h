// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include "app/cli/label_flags.h"
#include "app/cli/option_kinds.h"

namespace sline::cli {

/// Declares the flags of `LabelFlags` on a sub-command; `size` says what labels' points are of.
inline void addLabelOptions(CLI::App& command, LabelFlags& flags, const std::string& size) {
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
  command.add_option("--label-size", flags.points, "Of labels' letters, in points of " + size)
      ->type_name("PT")
      ->check(within(render::letterLimitsPt))
      ->capture_default_str();
  command
      .add_option("--marks", flags.marks,
                  "What stands at the picture's edges: on, off, or some of sides (R and L, and the "
                  "other sides of the body), view (its name), scale (a bar) and sections (what "
                  "they have taken away), as in sides,scale")
      ->type_name("on|off|LIST")
      ->capture_default_str();
}

}  // namespace sline::cli
