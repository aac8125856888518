// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/export/order/export_order.h"

namespace sline::render {

/// Cards that ask for the labels of the order's picture (`ankiCards`). A name that ends with .apkg
/// becomes a package that Anki opens; with .zip, deck.txt and the pictures in a ZIP; any other a
/// new folder of those.
Status writeAnki(const ExportOrder& order, const std::filesystem::path& target,
                 const ExportProgress& progress);

}  // namespace sline::render
