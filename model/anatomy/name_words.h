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

/// Returns the word, in lower case, as it is written where there are no umlauts: "hüftbein" →
/// "hueftbein", "spiserør" → "spiseroer".
std::string plainSpelling(std::string_view word);

/// Returns the name with a counter that tells it from others that are called the same: "liver
/// segment (no. 2)". Unlike a bare number it is no part of what the thing is called: `wordsOf` and
/// what is made of it pass over it.
std::string withCounter(std::string name, int number);
/// Returns the name without such a counter, in any of the languages of names ("(Nr. 2)").
std::string_view withoutCounter(std::string_view name);

enum class Side { none, left, right };

}  // namespace sline::model
