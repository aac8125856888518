// SPDX-License-Identifier: Apache-2.0
// Knows "left" and "right" in the languages in which structures are named.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/anatomy/name_words.h"

namespace sline::model {

enum class NameLanguage { english, latin, german, dutch, norwegian };
constexpr std::size_t nameLanguages = 5;
/// The languages' tags (BCP 47), in their order.
inline constexpr std::array<std::string_view, nameLanguages> nameLanguageTags{"en", "la", "de",
                                                                              "nl", "nb"};
/// Returns the language of a tag, whatever its region ("de-AT"); nothing for other languages.
std::optional<NameLanguage> nameLanguageOf(std::string_view tag);

/// Lists the genders with which "left" and "right" agree in Latin and German.
enum class Gender { none, masculine, feminine, neuter };
struct Agreement {
  Gender gender = Gender::none;
  bool plural = false;
  bool operator==(const Agreement&) const = default;
};

/// Returns the side that the word alone names in any of the languages, or none for other words.
Side sideOfWord(std::string_view word);

/// Returns the side that the word at this place of a name's words (`wordsOf`) says: like
/// `sideOfWord`, and by an abbreviation that elsewhere may be a person's name or another word
/// ("Niere_li", "re. Lunge", "nyre hø", "ren sin") where it stands first or, numbers and letters
/// aside, last.
Side sideAt(const std::vector<std::string>& words, std::size_t at);

/// Tells whether the word at this place is such an abbreviation.
bool isSideAbbreviation(const std::vector<std::string>& words, std::size_t at);

/// Returns the name with its side where the language puts it: "linke Niere", "ren sinister".
std::string withSide(const std::string& name, Side side, NameLanguage language,
                     const Agreement& agreement);

}  // namespace sline::model
