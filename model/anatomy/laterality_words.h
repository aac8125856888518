// SPDX-License-Identifier: Apache-2.0
// Left and right in the languages that structures' names come in.
#pragma once

#include <string>
#include <string_view>

#include "model/anatomy/name_words.h"

namespace sline::model {

enum class NameLanguage { english, latin, german, dutch, norwegian };
constexpr std::size_t nameLanguages = 5;

/// What "left" and "right" agree with in Latin and German.
enum class Gender { none, masculine, feminine, neuter };
struct Agreement {
  Gender gender = Gender::none;
  bool plural = false;
  bool operator==(const Agreement&) const = default;
};

/// The side that the word alone says, in any of the languages; none for all other words.
Side sideOfWord(std::string_view word);

/// The name with its side at the place where the language has it: "linke Niere", "ren sinister".
std::string withSide(const std::string& name, Side side, NameLanguage language,
                     const Agreement& agreement);

}  // namespace sline::model
