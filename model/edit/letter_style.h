// SPDX-License-Identifier: Apache-2.0
// Markers of a callout's text put around what is selected, or taken away.
#pragma once

#include <string>
#include <string_view>

#include "model/scene/markup.h"

namespace sline::model {

/// Bytes of UTF-8, whole characters.
struct TextRange {
  std::size_t begin = 0;
  std::size_t end = 0;
  bool operator==(const TextRange&) const = default;
};

struct MarkedText {
  std::string text;
  TextRange selection;  ///< what was selected; the cursor, where nothing was
};

enum class LetterMark { bold, italic };

/// All that is selected is of that style afterwards, or, where it was already, no longer; what is
/// shown stays the same words. Where nothing is selected, a pair of markers around the cursor, or
/// without the empty pair that is there.
MarkedText withLetterStyle(std::string_view text, TextRange selection, LetterMark mark);

}  // namespace sline::model
