// SPDX-License-Identifier: Apache-2.0
// The words that a structure's name is made of.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sline::model {

/// Lower-case words as they stand: "Rib6_left" → rib, 6, left; "Venae hepaticae" → venae,
/// hepaticae.
std::vector<std::string> wordsOf(std::string_view name);
/// The same in the singular: "kidneyCysts" → kidney, cyst.
std::vector<std::string> nameWords(std::string_view name);
/// English plurals and the spellings that anatomists mix; the word is in lower case.
std::string singular(std::string word);

enum class Side { none, left, right };

}  // namespace sline::model
