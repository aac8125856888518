// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "model/base/result.h"
#include "render/export/slides/slide_deck.h"

namespace sline::render {

/// Returns the slides as a .pptx file: a package of ECMA-376's transitional kind. The same deck
/// gives the same bytes; it says nothing of when, where and by whom it was made but the credit.
Result<std::string> slidePackage(const SlideDeck& deck);

}  // namespace sline::render
