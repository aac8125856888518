// SPDX-License-Identifier: Apache-2.0
#include "model/anatomy/name_words.h"

#include <algorithm>
#include <array>
#include <utility>

#include "model/base/letters.h"

namespace sline::model {

namespace {

/// Returns UTF-8 text in lower case: ASCII and the letters of Western Europe (À to Þ, which follow
/// the byte C3).
std::string lowerCaseOfUtf8(std::string text) {
  char before = 0;
  for (char& c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (isUpper(c))
      c = lowerCase(c);
    else if (before == '\xc3' && byte >= 0x80 && byte <= 0x9e && byte != 0x97)
      c = char(byte + 0x20);
    before = c;
  }
  return text;
}

using Words = std::vector<std::string>;

template <std::size_t N>
bool isOneOf(const std::string& word, const std::array<std::string_view, N>& list) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

constexpr std::array<std::string_view, 4> targets{"gtv", "ctv", "ptv", "itv"};
constexpr std::array<std::string_view, 12> takeTheRest{"without", "minus", "except", "excluding",
                                                       "sparing", "ohne",  "sans",   "sine",
                                                       "zonder",  "uten",  "excl",   "exkl"};
constexpr std::array<std::string_view, 8> takeTheNext{"no",    "non",   "not",  "kein",
                                                      "keine", "nicht", "geen", "ikke"};
constexpr std::array<std::string_view, 7> whatOneIsFreeOf{
    "tumour", "tumor", "lesion", "cancer", "disease", "metastasis", "carcinoma"};

/// Returns the name before a dash that takes a target volume away.
std::string_view beforeSubtraction(std::string_view name) {
  for (std::size_t at = name.find('-', 1); at != std::string_view::npos;
       at = name.find('-', at + 1)) {
    const bool follows = isLetter(name[at - 1]) || isDigit(name[at - 1]);
    const Words rest = wordsOf(name.substr(at + 1));
    const bool atOnce = at + 1 < name.size() && isLetter(name[at + 1]);
    if (follows && atOnce && !rest.empty() && isOneOf(rest.front(), targets))
      return name.substr(0, at);
  }
  return name;
}

}  // namespace

std::string plainSpelling(std::string_view word) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 7> spellings{
      {{"ä", "ae"}, {"ö", "oe"}, {"ü", "ue"}, {"ß", "ss"}, {"ø", "oe"}, {"å", "aa"}, {"æ", "ae"}}};
  std::string plain;
  for (std::size_t at = 0; at < word.size();) {
    const auto found = std::find_if(spellings.begin(), spellings.end(), [&](const auto& each) {
      return word.substr(at).starts_with(each.first);
    });
    plain += found == spellings.end() ? word.substr(at, 1) : found->second;
    at += found == spellings.end() ? 1 : found->first.size();
  }
  return plain;
}

std::string withCounter(std::string name, int number) {
  name += " (no. ";
  name += std::to_string(number);
  name += ')';
  return name;
}

std::string_view withoutCounter(std::string_view name) {
  const std::size_t at = name.rfind(" (");
  if (at == std::string_view::npos || at == 0 || !name.ends_with(')'))
    return name;
  std::string_view inside = name.substr(at + 2, name.size() - at - 3);
  if (!inside.starts_with("no. ") && !inside.starts_with("nr. ") && !inside.starts_with("Nr. "))
    return name;
  inside.remove_prefix(4);
  const bool counts = !inside.empty() && std::all_of(inside.begin(), inside.end(), isDigit);
  return counts ? name.substr(0, at) : name;
}

std::vector<std::string> wordsOf(std::string_view name) {
  name = withoutCounter(name);
  std::vector<std::string> words;
  std::string word;
  const auto finish = [&] {
    if (!word.empty())
      words.push_back(lowerCaseOfUtf8(word));
    word.clear();
  };
  for (const char c : name) {
    if (!isLetter(c) && !isDigit(c)) {
      finish();
      continue;
    }
    if (!word.empty()) {
      const char last = word.back();
      // "kidneyCyst" and "Rib6" hold two words each; "L5" and "T12" hold one.
      if ((isLower(last) && isUpper(c)) || (isDigit(c) && isLetter(last) && word.size() > 1))
        finish();
    }
    word += c;
  }
  finish();
  return words;
}

std::vector<std::string> nameWords(std::string_view name) {
  std::vector<std::string> words = wordsOf(name);
  for (std::string& word : words)
    word = singular(std::move(word));
  return words;
}

std::vector<std::string> affirmedWords(std::string_view name) {
  const Words words = nameWords(beforeSubtraction(name));
  // "PTV bladder" is for the bladder's tumour, and "PTV-Bladder" without the bladder.
  if (!words.empty() && isOneOf(words.front(), targets))
    return {words.front()};
  Words affirmed;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (isOneOf(words[i], takeTheRest))
      break;
    if (isOneOf(words[i], takeTheNext)) {
      ++i;
      continue;
    }
    const bool freeOf =
        i + 1 < words.size() && words[i + 1] == "free" && isOneOf(words[i], whatOneIsFreeOf);
    if (freeOf)
      ++i;
    else
      affirmed.push_back(words[i]);
  }
  return affirmed;
}

std::string singular(std::string word) {
  if (word == "disk" || word == "disks" || word == "discs")
    return "disc";
  if (word == "vertebrae")
    return "vertebra";
  if (word == "calyces" || word == "calices")
    return "calyx";
  if (word == "bronchi")
    return "bronchus";
  if (word == "metastases")
    return "metastasis";
  if (word == "nuclei")
    return "nucleus";
  if (word == "ganglia")
    return "ganglion";
  if (word.size() > 4 && word.ends_with("ies"))
    return word.substr(0, word.size() - 3) + "y";
  const bool latin = word.ends_with("ss") || word.ends_with("us") || word.ends_with("is") ||
                     word.ends_with("ps") || word.ends_with("as");
  if (word.size() > 3 && word.ends_with('s') && !latin)
    word.pop_back();
  return word;
}

}  // namespace sline::model
