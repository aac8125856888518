// SPDX-License-Identifier: Apache-2.0
#include "model/import/names.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

namespace sline::model {

namespace {

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}
bool isUpper(char c) {
  return c >= 'A' && c <= 'Z';
}
bool isLower(char c) {
  return c >= 'a' && c <= 'z';
}
bool isLetter(char c) {
  return isUpper(c) || isLower(c) || (c & '\x80') != 0;
}
char lower(char c) {
  return isUpper(c) ? char(c - 'A' + 'a') : c;
}

std::string lowered(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(), lower);
  return result;
}

bool allDigits(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), isDigit);
}

/// "FJ3152", "FJ1426M", "FMA16586", "UBERON0002107": letters of a catalogue, then a number.
bool isCatalogueId(const std::string& word) {
  for (const std::string_view catalogue : {"fj", "fma", "bp", "uberon", "snomed"}) {
    if (!word.starts_with(catalogue))
      continue;
    std::string_view number = std::string_view(word).substr(catalogue.size());
    if (catalogue == "fj" && number.ends_with('m'))
      number.remove_suffix(1);
    if (allDigits(number))
      return true;
  }
  return false;
}

struct Part {
  std::size_t begin;
  std::string word;  ///< lower case
};

std::vector<Part> cutAt(std::string_view text, std::string_view separators) {
  std::vector<Part> parts;
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t end = std::min(text.find_first_of(separators, at), text.size());
    if (end > at)
      parts.push_back({at, lowered(text.substr(at, end - at))});
    at = end + 1;
  }
  return parts;
}

/// How many leading parts are catalogue ids.
std::size_t cataloguePrefix(const std::vector<Part>& parts) {
  std::size_t i = 0;
  const auto word = [&](std::size_t k) { return k < parts.size() ? parts[k].word : std::string(); };
  while (i < parts.size()) {
    const bool collection =
        (word(i) == "vh" || word(i) == "sbu") && (word(i + 1) == "m" || word(i + 1) == "f");
    const bool numbered = (word(i) == "model" || word(i) == "segment" || word(i) == "label" ||
                           word(i) == "uberon" || word(i) == "fma") &&
                          allDigits(word(i + 1));
    const bool printed = word(i) == "3d" && word(i + 1) == "vh";
    if (collection || numbered)
      i += 2;
    else if (printed || isCatalogueId(word(i)) || allDigits(word(i)))
      i += 1;
    else
      break;
  }
  return i;
}

std::string withSpaces(std::string_view text) {
  std::string result;
  for (const char c : text) {
    const bool space = c == '_' || static_cast<unsigned char>(c) <= ' ';
    if (!space)
      result += c;
    else if (!result.empty() && result.back() != ' ')
      result += ' ';
  }
  while (!result.empty() && result.back() == ' ')
    result.pop_back();
  return result;
}

/// The text behind its catalogue ids, or nothing where there are none or nothing else.
std::string_view behindCatalogue(std::string_view text) {
  const std::vector<Part> parts = cutAt(text, "_- \t");
  const std::size_t skip = cataloguePrefix(parts);
  if (skip == 0 || skip >= parts.size())
    return {};
  const std::string_view rest = text.substr(parts[skip].begin);
  return std::any_of(rest.begin(), rest.end(), isLetter) ? rest : std::string_view();
}

std::string numbered(std::string name, int number) {
  name += ' ';
  name += std::to_string(number);
  return name;
}

/// English plurals and the spellings that anatomists mix.
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
  if (word.size() > 4 && word.ends_with("ies"))
    return word.substr(0, word.size() - 3) + "y";
  const bool latin = word.ends_with("ss") || word.ends_with("us") || word.ends_with("is") ||
                     word.ends_with("ps") || word.ends_with("as");
  if (word.size() > 3 && word.ends_with('s') && !latin)
    word.pop_back();
  return word;
}

Side sideOf(const std::string& word) {
  if (word == "left" || word == "l" || word == "lt" || word == "sinister" || word == "sinistra")
    return Side::left;
  if (word == "right" || word == "r" || word == "rt" || word == "dexter" || word == "dextra")
    return Side::right;
  return Side::none;
}

}  // namespace

std::string readableName(std::string_view stem) {
  const std::string_view rest = behindCatalogue(stem);
  const std::string name = withSpaces(rest.empty() ? stem : rest);
  return name.empty() ? std::string(stem) : name;
}

std::string nameInFile(std::string_view name) {
  const std::string plain = lowered(name);
  for (const char* boast : {"visualization toolkit generated", "vtk output", "exported from",
                            "generated by", "created by", "openscad_model"})
    if (plain.find(boast) != std::string::npos)
      return {};
  return withSpaces(readableName(name));
}

std::vector<std::string> nameWords(std::string_view name) {
  std::vector<std::string> words;
  std::string word;
  const auto finish = [&] {
    if (!word.empty())
      words.push_back(singular(lowered(word)));
    word.clear();
  };
  for (const char c : name) {
    if (!isLetter(c) && !isDigit(c)) {
      finish();
      continue;
    }
    if (!word.empty()) {
      const char last = word.back();
      // "kidneyCyst" and "Rib6" hold two words each, "L5" and "T12" one.
      if ((isLower(last) && isUpper(c)) || (isDigit(c) && isLetter(last) && word.size() > 1))
        finish();
    }
    word += c;
  }
  finish();
  return words;
}

SidedName sidedName(std::string_view name) {
  SidedName result;
  for (const std::string& word : nameWords(name)) {
    const Side side = sideOf(word);
    // A name with both sides in it ("left duct of right lobe") has that of its first.
    if (side != Side::none && result.side == Side::none) {
      result.side = side;
      continue;
    }
    if (!result.rest.empty())
      result.rest += ' ';
    result.rest += word;
  }
  return result;
}

void makeUnique(std::vector<std::string>& names) {
  std::set<std::string> taken;
  for (const std::string& name : names)
    taken.insert(lowered(name));
  std::set<std::string> seen;
  std::map<std::string, int> next;
  for (std::string& name : names) {
    const std::string key = lowered(name);
    if (seen.insert(key).second)
      continue;
    int& number = next.try_emplace(key, 2).first->second;
    while (taken.contains(numbered(key, number)))
      ++number;
    name = numbered(name, number);
    taken.insert(lowered(name));
    seen.insert(lowered(name));
    ++number;
  }
}

}  // namespace sline::model
