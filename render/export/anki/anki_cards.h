// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/export/anki/anki_deck.h"
#include "render/export/order/export_order.h"

namespace sline::render {

/// Draws each picture of the order once and makes its questions (`questionsOf`) into cards: what is
/// written for a card is a picture of its own over that one. Where the order wants all views, each
/// has a deck in the deck. Pictures are no wider than 1600 pixels, and letters no smaller than a
/// phone needs. The error reports that there is nothing to ask for; progress may stop it
/// (`givenUp`).
Result<AnkiDeck> ankiCards(const ExportOrder& order, const ExportProgress& progress);

}  // namespace sline::render
