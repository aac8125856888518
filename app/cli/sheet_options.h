// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include "app/cli/sheet_flags.h"

namespace sline::cli {

/// Declares the flags of `SheetFlags` on a sub-command that has --size-mm and --size-px.
inline void addSheetOptions(CLI::App& command, SheetFlags& flags) {
  CLI::Option* sheet =
      command
          .add_option(
              "--sheet", flags.kind,
              "Makes the PDF a sheet of paper. figure: with title and legend; teaching: "
              "besides, numbered labels, a page without them to test oneself and the key "
              "(a scene without labels gets its structures labelled); patient: large "
              "labels and a text of one's own. The figure is as large as the paper lets it, and so "
              "are pictures of it that are written besides")
          ->type_name("figure|teaching|patient")
          ->excludes("--size-mm")
          ->excludes("--size-px");
  command.add_option("--paper", flags.paper, "The sheet's paper")
      ->type_name("a4|letter")
      ->needs(sheet)
      ->capture_default_str();
  command.add_flag("--landscape", flags.landscape, "The sheet's paper lies on its side")
      ->needs(sheet);
  command.add_option("--title", flags.title, "Above the sheet's figure")->needs(sheet);
  command
      .add_option("--text", flags.text,
                  "What the sheet for a patient says, or the name of a text file; each line is a "
                  "paragraph")
      ->type_name("FILE_OR_TEXT")
      ->needs(sheet);
}

}  // namespace sline::cli
