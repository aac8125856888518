// SPDX-License-Identifier: Apache-2.0
#include "model/anatomy/kin_names.h"

#include <algorithm>
#include <array>

#include "model/anatomy/anatomical_names.h"
#include "model/anatomy/laterality_words.h"
#include "model/base/letters.h"

namespace sline::model {

namespace {

/// Tells whether the word counts rather than names: "12", "viii", "third", "t12", "a".
bool counts(const std::string& word) {
  static constexpr std::array<std::string_view, 12> ordinals{
      "first",   "second", "third", "fourth", "fifth",    "sixth",
      "seventh", "eighth", "ninth", "tenth",  "eleventh", "twelfth"};
  return word.size() <= 1 || std::any_of(word.begin(), word.end(), isDigit) ||
         word.find_first_not_of("ivx") == std::string::npos ||
         std::find(ordinals.begin(), ordinals.end(), word) != ordinals.end();
}

/// Tells whether the word is a number of an atlas' table ("Insula L 3001"), which tells nothing of
/// kin: the other side has another.
bool isCode(const std::string& word) {
  constexpr std::size_t fewestDigits = 3;
  return word.size() >= fewestDigits && std::all_of(word.begin(), word.end(), isDigit);
}

}  // namespace

KinName kinName(std::string_view name) {
  static const AnatomicalNames names;
  const std::vector<std::string> words = nameWords(names.displayName(name, NameLanguage::english));
  const auto has = [&words](std::string_view word) {
    return std::find(words.begin(), words.end(), word) != words.end();
  };
  KinName kin;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (const Side side = sideAt(words, i); side != Side::none) {
      kin.side = side;
      continue;
    }
    if (isCode(word))
      continue;
    kin.pair += word + ' ';
    if (!counts(word))
      kin.family += word + ' ';
  }
  if (has("intervertebral") || has("disc"))
    kin.family = "disc ";
  else if (has("vertebra"))
    kin.family = "vertebra ";
  return kin;
}

}  // namespace sline::model
