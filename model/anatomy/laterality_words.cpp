// SPDX-License-Identifier: Apache-2.0
#include "model/anatomy/laterality_words.h"

#include <algorithm>
#include <array>

#include "model/base/letters.h"

namespace sline::model {

namespace {

constexpr std::array<std::string_view, 17> leftWords{
    "left",     "l",        "lt",                                            // English
    "links",    "linke",    "linker",    "linkes",   "linken",    "linkse",  // German, Dutch
    "sinister", "sinistra", "sinistrum", "sinistri", "sinistrae",            // Latin
    "venstre",  "vänster",  "venstres"};  // Norwegian and neighbours

constexpr std::array<std::string_view, 19> rightWords{
    "right",  "r",      "rt",                                        // English
    "rechts", "rechte", "rechter", "rechtes", "rechten", "rechtse",  // German, Dutch
    "dexter", "dextra", "dextrum", "dextri",  "dextrae",             // Latin
    "høyre",  "höger",  "høyres",  "hoeyre",  "hoyre"};              // Norwegian and neighbours

// German and Dutch, Norwegian, Latin, and what Italians and Spaniards write.
constexpr std::array<std::string_view, 5> leftAbbreviations{"li", "lks", "ve", "sin", "sx"};
constexpr std::array<std::string_view, 5> rightAbbreviations{"re", "rts", "hø", "dext", "dx"};

/// Holds the nominatives: masculine, feminine and neuter, first the singular, then the plural.
struct LatinForms {
  std::array<const char*, 3> singular;
  std::array<const char*, 3> plural;
};
constexpr LatinForms latinLeft{{"sinister", "sinistra", "sinistrum"},
                               {"sinistri", "sinistrae", "sinistra"}};
constexpr LatinForms latinRight{{"dexter", "dextra", "dextrum"}, {"dextri", "dextrae", "dextra"}};

std::size_t place(const Agreement& agreement) {
  return agreement.gender == Gender::none ? 0 : std::size_t(agreement.gender) - 1;
}

std::string latin(Side side, const Agreement& agreement) {
  const LatinForms& forms = side == Side::left ? latinLeft : latinRight;
  return (agreement.plural ? forms.plural : forms.singular)[place(agreement)];
}

/// Returns the adjective for use without an article: "linker Harnleiter, linke Niere, linkes
/// Schulterblatt, linke Arterien".
std::string german(Side side, const Agreement& agreement) {
  constexpr std::array<const char*, 3> endings{"er", "e", "es"};
  return std::string(side == Side::left ? "link" : "recht") +
         (agreement.plural ? "e" : endings[place(agreement)]);
}

}  // namespace

Side sideOfWord(std::string_view word) {
  const auto among = [word](const auto& words) {
    return std::find(words.begin(), words.end(), word) != words.end();
  };
  if (among(leftWords))
    return Side::left;
  return among(rightWords) ? Side::right : Side::none;
}

bool isSideAbbreviation(const std::vector<std::string>& words, std::size_t at) {
  return sideOfWord(words[at]) == Side::none && sideAt(words, at) != Side::none;
}

Side sideAt(const std::vector<std::string>& words, std::size_t at) {
  if (const Side whole = sideOfWord(words[at]); whole != Side::none)
    return whole;
  const auto tells = [](const std::string& word) {
    return word.size() > 1 && !std::all_of(word.begin(), word.end(), isDigit);
  };
  const auto from = words.begin() + std::ptrdiff_t(at);
  const bool first = std::none_of(words.begin(), from, tells);
  const bool last = std::none_of(from + 1, words.end(), tells);
  if (first == last)  // in the midst, or alone
    return Side::none;
  const auto among = [&from](const auto& list) {
    return std::find(list.begin(), list.end(), *from) != list.end();
  };
  if (among(leftAbbreviations))
    return Side::left;
  return among(rightAbbreviations) ? Side::right : Side::none;
}

std::string withSide(const std::string& name, Side side, NameLanguage language,
                     const Agreement& agreement) {
  if (side == Side::none)
    return name;
  const bool left = side == Side::left;
  switch (language) {
    case NameLanguage::english:
      return (left ? "left " : "right ") + name;
    case NameLanguage::latin:
      return name + ' ' + latin(side, agreement);
    case NameLanguage::german:
      return german(side, agreement) + ' ' + name;
    case NameLanguage::dutch:
      return (left ? "linker " : "rechter ") + name;
    case NameLanguage::norwegian:
      return (left ? "venstre " : "høyre ") + name;
  }
  return name;
}

std::optional<NameLanguage> nameLanguageOf(std::string_view tag) {
  const std::string_view primary = tag.substr(0, tag.find_first_of("-_"));
  if (primary == "no")  // Norwegian of either form
    return NameLanguage::norwegian;
  const auto found = std::find(nameLanguageTags.begin(), nameLanguageTags.end(), primary);
  if (found == nameLanguageTags.end())
    return std::nullopt;
  return NameLanguage(found - nameLanguageTags.begin());
}

}  // namespace sline::model
