// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include "app/cli/option_kinds.h"
#include "app/cli/pixel_flags.h"

namespace sline::cli {

/// Declares the flags of `PixelFlags` on a sub-command that has --size-mm.
inline void addPixelOptions(CLI::App& command, PixelFlags& flags) {
  command
      .add_option("--size-px", flags.sizePx,
                  "Width and height in pixels instead, 16 to 20000 each; the page is as large as "
                  "they are at --dpi")
      ->type_name("WxH")
      ->excludes("--size-mm");
  command.add_option("--dpi", flags.dpi, "Pixels to the inch, for png, tiff, jpeg and exr")
      ->type_name("N")
      ->check(within(render::dpiLimits))
      ->capture_default_str();
  command.add_option("--bits", flags.bits, "Of a channel in png and tiff; 1 needs --bw")
      ->type_name("8|16|1")
      ->capture_default_str();
  command.add_flag("--grey,--gray", flags.grey, "Without colours, for png, tiff, jpeg and exr");
  command
      .add_option("--samples", flags.samples,
                  "Draws this many times as large both ways and averages, for smooth edges: 1 to "
                  "4; auto decides by the size")
      ->type_name("auto|N")
      ->capture_default_str();
}

}  // namespace sline::cli
