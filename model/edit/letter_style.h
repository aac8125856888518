// SPDX-License-Identifier: Apache-2.0
// Puts markers around the selected part of a callout's text, or takes them away.
#pragma once

#include <string>
#include <string_view>

#include "model/scene/markup.h"

namespace sline::model {

/// A range of UTF-8 bytes that covers whole characters.
struct TextRange {
  std::size_t begin = 0;
  std::size_t end = 0;
  bool operator==(const TextRange&) const = default;
};

struct MarkedText {
  std::string text;
  TextRange selection;  ///< the former selection, or the cursor where nothing was selected
};

enum class LetterMark { bold, italic };

/// Gives the whole selection that style or, where it already has it, takes the style away; the
/// visible words stay the same. Where nothing is selected, it puts a pair of markers around the
/// cursor, or removes the empty pair that is there.
MarkedText withLetterStyle(std::string_view text, TextRange selection, LetterMark mark);

}  // namespace sline::model
