// SPDX-License-Identifier: Apache-2.0
// Splits a structure's name into words.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sline::model {

/// Returns the words in lower case but otherwise unchanged: "Rib6_left" → rib, 6, left; "Venae
/// hepaticae" → venae, hepaticae.
std::vector<std::string> wordsOf(std::string_view name);
/// Returns the words in lower case and in the singular: "kidneyCysts" → kidney, cyst.
std::vector<std::string> nameWords(std::string_view name);
/// Returns the words, as `nameWords` does, of what the thing is: what its name takes away is left
/// out, as in "liver without tumour", "no tumour", "tumour-free margin" and, as plans of
/// radiotherapy write it, "Liver-GTV" (Mayo et al., TG-263, Int J Radiat Oncol 2018).
std::vector<std::string> affirmedWords(std::string_view name);
/// Returns the singular of an English plural, and one spelling where anatomists mix several; the
/// word is in lower case.
std::string singular(std::string word);

enum class Side { none, left, right };

}  // namespace sline::model
