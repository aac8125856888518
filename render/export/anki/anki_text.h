// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "render/export/anki/anki_deck.h"

namespace sline::render {

/// Returns the deck as a text file that Anki imports ("Text Files" in its manual): a line for each
/// note holds, between tabs, its id, the front (the question's picture), the back (the answer's
/// picture and the label) and tags, in HTML.
std::string ankiText(const AnkiDeck& deck);

}  // namespace sline::render
