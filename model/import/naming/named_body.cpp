// SPDX-License-Identifier: Apache-2.0
#include "model/import/naming/named_body.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "model/anatomy/name_words.h"
#include "model/base/letters.h"

namespace sline::model {

namespace {

template <std::size_t n>
bool isAmong(const std::string& word, const std::array<std::string_view, n>& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// "VH" is the Visible Human, "SBU" the atlas of the same makers for the large intestine.
constexpr std::array<std::string_view, 12> bodies{"vh",    "sbu",   "hra",     "body",
                                                  "human", "adult", "patient", "subject",
                                                  "sex",   "atlas", "koerper", "kropp"};
constexpr std::array<std::string_view, 8> women{"female", "woman",      "frau",   "weiblich",
                                                "vrouw",  "vrouwelijk", "kvinne", "kvinnelig"};
constexpr std::array<std::string_view, 6> men{"male",      "man",       "mann",
                                              "maennlich", "mannelijk", "mannlig"};

}  // namespace

std::string sexInName(std::string_view name) {
  bool female = false;
  bool male = false;
  std::string before;
  for (const std::string& written : wordsOf(name)) {
    const std::string word = plainSpelling(written);
    const bool ofBody = isAmong(before, bodies);
    female = female || isAmong(word, women) || (ofBody && word == "f");
    male = male || isAmong(word, men) || (ofBody && word == "m");
    before = word;
  }
  return female == male ? "" : female ? "f" : "m";
}

std::string numberInName(std::string_view name) {
  static constexpr std::array<std::string_view, 6> counted{"patient", "subject",   "case",
                                                           "proband", "patientin", "pasient"};
  std::string before;
  for (const std::string& word : wordsOf(name)) {
    if (isAmong(before, counted) && std::all_of(word.begin(), word.end(), isDigit))
      return word.substr(std::min(word.find_first_not_of('0'), word.size() - 1));
    before = word;
  }
  return {};
}

}  // namespace sline::model
