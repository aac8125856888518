// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "render/export/order/export_order.h"

namespace sline::cli {

/// Declares the flags of decks of cards on a sub-command.
inline void addAnkiOptions(CLI::App& command, render::AnkiOptions& flags) {
  command
      .add_option("--deck", flags.deck,
                  "What Anki's deck is called, else as the view; \"::\" parts decks from those in "
                  "them")
      ->type_name("NAME");
  command
      .add_flag("--other-labels,!--no-other-labels", flags.othersShown,
                "Anki's cards show the labels that they do not ask for, too")
      ->default_str("false");
}

}  // namespace sline::cli
