// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/export/order/export_order.h"

namespace sline::render {

/// Writes cards that ask for the labels of the order's picture (`ankiCards`). A name that ends with
/// .apkg gives a package that Anki opens; .zip gives a ZIP of deck.txt and the pictures; any other
/// name gives a new folder of those.
Status writeAnki(const ExportOrder& order, const std::filesystem::path& target,
                 const ExportProgress& progress);

/// Returns how many cards the order's deck has if all labels find a place.
std::size_t ankiCardsAtMost(const ExportOrder& order);

}  // namespace sline::render
