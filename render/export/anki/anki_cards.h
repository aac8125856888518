// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/export/anki/anki_deck.h"
#include "render/export/order/export_order.h"

namespace sline::render {

/// Draws the order's picture once and over it, for each label that has a place in it, a question (a
/// box at the end of the leader) and the answer; the pictures are no wider than 1600 pixels. The
/// error reports a scene without labels; progress may stop it (`givenUp`).
Result<AnkiDeck> ankiCards(const ExportOrder& order, const ExportProgress& progress);

}  // namespace sline::render
