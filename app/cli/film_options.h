// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include "app/cli/film_flags.h"
#include "app/cli/option_kinds.h"

namespace sline::cli {

/// Declares the flags of `FilmFlags` on a sub-command.
inline void addFilmOptions(CLI::App& command, FilmFlags& flags) {
  command.add_option("--video", flags.file, "A film of the kind that its extension tells")
      ->type_name("FILE.{mp4,webp,gif}");
  command
      .add_option("--motion", flags.motion,
                  "What moves in a film: turntable takes the camera once around, from the front to "
                  "the patient's left; tour goes through the saved views; gamma-sweep takes Γ from "
                  "0 to 5")
      ->type_name("turntable|tour|gamma-sweep")
      ->capture_default_str();
  command.add_option("--seconds", flags.seconds, "How long a film is")
      ->type_name("S")
      ->check(within(render::filmSecondsLimits))
      ->capture_default_str();
  command.add_option("--fps", flags.framesPerSecond, "Frames per second; GIF: at most 50")
      ->type_name("N")
      ->check(within(render::framesPerSecondLimits))
      ->capture_default_str();
  command
      .add_option("--film-height", flags.height,
                  "Of a film, in pixels; the page's shape gives the width")
      ->type_name("PIXELS")
      ->check(within(render::filmHeightLimits))
      ->capture_default_str();
  command
      .add_option("--hold", flags.hold,
                  "Seconds of rest at each view of a tour, or at either end of a gamma-sweep; else "
                  "2/5 or 1/6 of the film together")
      ->type_name("S");
  many(command.add_option(
           "--sweep", flags.swept,
           "A structure or group whose Γ a gamma-sweep changes, else everything's; may be "
           "given again"))
      ->type_name("NAME");
}

}  // namespace sline::cli
