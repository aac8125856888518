// SPDX-License-Identifier: Apache-2.0
// Declares the options of decks of cards that ask for labels.
#pragma once

#include <string>

#include "render/export/order/export_option.h"

namespace sline::render {

struct AnkiOptions {
  std::string deck;    ///< the deck's name; empty: the view's, or "Anatomy"
  bool nameIt = true;  ///< cards mark a place and ask what it is
  bool findIt = true;  ///< cards name something and ask which number it has
  bool cover = false;  ///< cards show all names but one, which is covered
};

OptionList ankiOptions();

extern const ExportOption cardsOption;

/// Tells whether there is any kind of card at all.
bool hasCards(const AnkiOptions& options);

}  // namespace sline::render
