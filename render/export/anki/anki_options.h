// SPDX-License-Identifier: Apache-2.0
// Declares the options of decks of cards that ask for labels.
#pragma once

#include <string>

#include "render/export/order/export_option.h"

namespace sline::render {

struct AnkiOptions {
  std::string deck;            ///< the deck's name; empty: the view's, or "Anatomy"
  bool othersShown = false;    ///< a card also shows the other labels
  bool calloutsAsked = false;  ///< callouts, which are sentences, are questions, too
};

OptionList ankiOptions();

}  // namespace sline::render
