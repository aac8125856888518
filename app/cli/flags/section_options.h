// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include "app/cli/flags/section_flags.h"

namespace sline::cli {

/// Declares the flags of `SectionFlags` on a sub-command.
inline void addSectionOptions(CLI::App& command, SectionFlags& flags) {
  const auto repeatable = [](CLI::Option* option) {
    return option->take_all()->type_size(1)->expected(1)->allow_extra_args(false);
  };
  repeatable(
      command.add_option("--section", flags.sections,
                         "Cuts everything open: sagittal, coronal or axial, at x, y or z in mm "
                         "(default: through the middle), and the side to keep (default: the one "
                         "away from the camera), as in axial=120:inferior; or nx,ny,nz,d, which "
                         "keeps nx*x+ny*y+nz*z <= d; may be given again"))
      ->type_name("PLANE[=MM][:SIDE]");
  repeatable(command.add_option("--section-group", flags.groups,
                                "Cuts this structure or group alone; may be given again"))
      ->type_name("NAME");
  command
      .add_option(
          "--section-faces", flags.faces,
          "How cut faces are drawn: off (paper), tint (of the structure's colour) or tissue "
          "(the tint with the pattern of bone, muscle, fat ...)")
      ->type_name("off|tint|tissue");
  command.add_flag("--section-hatching", flags.hatched,
                   "Hatches the cut faces that have no pattern at 45 degrees");
}

}  // namespace sline::cli
