// SPDX-License-Identifier: Apache-2.0
// The options of decks of cards that ask for labels.
#pragma once

#include <string>

#include "render/export/order/export_option.h"

namespace sline::render {

struct AnkiOptions {
  std::string deck;          ///< its name; empty: the view's, or "Anatomy"
  bool othersShown = false;  ///< a card shows the other labels, too
};

OptionList ankiOptions();

}  // namespace sline::render
