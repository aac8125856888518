// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "model/base/result.h"
#include "render/export/anki/anki_deck.h"

namespace sline::render {

/// Returns the deck as an .apkg file, which Anki opens by itself: a ZIP with an SQLite collection
/// (schema 11, which every version since 2.0 reads) and the pictures. The same deck gives the same
/// bytes.
Result<std::string> ankiPackage(const AnkiDeck& deck);

}  // namespace sline::render
