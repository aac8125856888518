// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "render/export/anki/anki_deck.h"

namespace sline::render {

/// Returns the deck as a text file that Anki imports ("Text Files" in its manual): a line for each
/// card holds, between tabs, its id, the front, the back, which ends with the label, tags, and the
/// name of its deck, in HTML but for the last.
std::string ankiText(const AnkiDeck& deck);

}  // namespace sline::render
