// SPDX-License-Identifier: Apache-2.0
#include "model/anatomy/anatomical_names.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "model/anatomy/names_table.h"

namespace sline::model {

namespace {

using Words = std::vector<std::string>;

/// Tells whether a word adds nothing to a name: "lobe of the liver" is "liver lobe".
bool isFiller(const std::string& word) {
  static constexpr std::array<std::string_view, 16> fillers{
      "of",  "the", "and", "der", "des", "die", "dem", "den",
      "das", "und", "van", "de",  "het", "en",  "av",  "og"};
  return std::find(fillers.begin(), fillers.end(), word) != fillers.end();
}

/// Tells whether a word says "muscle"; names of muscles occur with and without it.
bool saysMuscle(const std::string& word) {
  return word == "muscle" || word == "muscles" || word == "musculus" || word == "muskel" ||
         word == "spier";
}

std::string keyOf(Words words) {
  std::erase_if(words, isFiller);
  for (std::string& word : words)
    word = plainSpelling(word);
  std::sort(words.begin(), words.end());
  std::string key;
  for (const std::string& word : words)
    key += word + ' ';
  return key;
}

int ordinal(std::string_view word) {
  static constexpr std::array<std::string_view, 12> ordinals{
      "first",   "second", "third", "fourth", "fifth",    "sixth",
      "seventh", "eighth", "ninth", "tenth",  "eleventh", "twelfth"};
  const auto found = std::find(ordinals.begin(), ordinals.end(), word);
  return found == ordinals.end() ? 0 : int(found - ordinals.begin()) + 1;
}

/// Holds a word with a number in it: the number, and the word with # in its place ("l4" → "l#").
struct Numbered {
  int number = 0;
  std::string word;
};

std::optional<Numbered> numbered(const std::string& word) {
  if (const int number = ordinal(word) != 0 ? ordinal(word) : fromRoman(word))
    return Numbered{number, "#"};
  const bool coded = std::string_view("ctls").find(word.front()) != std::string_view::npos;
  const char* begin = word.data() + (coded ? 1 : 0);
  const char* end = word.data() + word.size();
  int number = 0;
  const auto [after, fault] = std::from_chars(begin, end, number);
  if (fault != std::errc())
    return std::nullopt;
  const std::string_view ending(after, std::size_t(end - after));
  if (coded)
    return ending.empty() ? std::optional(Numbered{number, word.substr(0, 1) + '#'}) : std::nullopt;
  for (const char* suffix : {"", "st", "nd", "rd", "th", "e"})
    if (ending == suffix)
      return Numbered{number, "#"};
  return std::nullopt;
}

/// Returns the words with # for the only number among them, and that number.
std::optional<std::pair<Words, int>> abstracted(Words words) {
  int number = 0;
  int found = 0;
  for (std::string& word : words)
    if (std::optional<Numbered> here = numbered(word)) {
      word = std::move(here->word);
      number = here->number;
      ++found;
    }
  if (found != 1)
    return std::nullopt;
  return std::pair(std::move(words), number);
}

/// Returns the level of the spine counted from the skull down, or 0 for any other word.
int levelOf(const std::string& word) {
  if (word == "sacrum")
    return levelOf("s1");
  const std::optional<Numbered> level = numbered(word);
  if (!level || level->word.size() != 2)
    return 0;
  switch (level->word.front()) {
    case 'c':
      return level->number;
    case 't':
      return 7 + level->number;
    case 'l':
      return 19 + level->number;
    default:
      return 24 + level->number;
  }
}

std::string levelName(int level) {
  if (level <= 7)
    return 'C' + std::to_string(level);
  if (level <= 19)
    return 'T' + std::to_string(level - 7);
  return level <= 24 ? 'L' + std::to_string(level - 19) : 'S' + std::to_string(level - 24);
}

bool beginsCapital(std::string_view name) {
  return name.size() > 1 && name[0] >= 'A' && name[0] <= 'Z' && name[1] >= 'a' && name[1] <= 'z';
}

std::string capitalised(std::string text) {
  if (text.empty())
    return text;
  const auto second = static_cast<unsigned char>(text.size() > 1 ? text[1] : 0);
  if (text[0] >= 'a' && text[0] <= 'z')
    text[0] = char(text[0] - 'a' + 'A');
  else if (text[0] == '\xc3' && second >= 0xa0 && second <= 0xbe && second != 0xb7)
    text[1] = char(second - 0x20);
  return text;
}

/// Returns the counter at the end of the name (`withCounter`) as the language writes it.
std::string counterOf(std::string_view name, NameLanguage language) {
  std::string counter(name.substr(withoutCounter(name).size()));
  const bool german = language == NameLanguage::german;
  const bool shortened = language == NameLanguage::dutch || language == NameLanguage::norwegian;
  if (const std::size_t at = counter.find("no. "); at != std::string::npos && (german || shortened))
    counter.replace(at, 2, german ? "Nr" : "nr");
  return counter;
}

/// Tells whether a word only tells apart structures of one name: "minor calyx a", "left kidney 2".
bool isTag(const std::string& word) {
  const bool number =
      std::all_of(word.begin(), word.end(), [](char c) { return c >= '0' && c <= '9'; });
  return number || (word.size() == 1 && sideOfWord(word) == Side::none);
}

}  // namespace

AnatomicalNames::AnatomicalNames() : AnatomicalNames(anatomicalNamesText()) {}

AnatomicalNames::AnatomicalNames(std::string_view table) : m_table(readNameRows(table)) {
  // Names are read before they are made singular: "veins" has its own row beside "vein".
  fill(wordsOf, true);
  fill(nameWords, false);
}

void AnatomicalNames::fill(Words (*wordsOfName)(std::string_view), bool exact) {
  for (std::size_t row = 0; row < rows().size(); ++row) {
    std::vector<std::string> names(rows()[row].names.begin(), rows()[row].names.end());
    names.insert(names.end(), rows()[row].synonyms.begin(), rows()[row].synonyms.end());
    for (const std::string& name : names) {
      const Words words = wordsOfName(withNumber(name, 1));
      const auto number = rows()[row].numbers ? abstracted(words) : std::nullopt;
      enter(keyOf(number ? number->first : words), row, exact);
    }
  }
}

void AnatomicalNames::enter(const std::string& key, std::size_t row, bool exact) {
  const auto [there, isNew] = m_index.try_emplace(key, row);
  if (exact && !isNew && there->second != row)
    m_ambiguities.push_back(key);
}

std::optional<AnatomicalNames::Found> AnatomicalNames::lookUp(const Words& words) const {
  if (words.empty())
    return std::nullopt;
  if (const auto row = m_index.find(keyOf(words)); row != m_index.end()) {
    const NameRow& found = rows()[row->second];
    if (!found.numbers)
      return Found{.row = &found, .tag = {}};
  }
  if (const auto number = abstracted(words)) {
    const auto row = m_index.find(keyOf(number->first));
    if (row != m_index.end() && rows()[row->second].numbers &&
        rows()[row->second].numbers->holds(number->second))
      return Found{.row = &rows()[row->second], .number = number->second, .tag = {}};
  }
  Words singulars = words;
  for (std::string& word : singulars)
    word = singular(word);
  if (singulars != words)
    return lookUp(singulars);
  Words bare = words;
  std::erase_if(bare, saysMuscle);
  return bare.size() < words.size() ? lookUp(bare) : std::nullopt;
}

std::optional<AnatomicalNames::Found> AnatomicalNames::lookUpSided(const Words& words) const {
  // "left gastric artery" has its own row.
  if (std::optional<Found> found = lookUp(words))
    return found;
  Side side = Side::none;
  Words rest;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const Side here = sideAt(words, i);
    if (here == Side::none)
      rest.push_back(words[i]);
    if (here != Side::none && side != Side::none && here != side)
      return std::nullopt;  // "left branch of right …": better as in the file than mixed up
    side = here == Side::none ? side : here;
  }
  if (side == Side::none)
    return std::nullopt;
  std::optional<Found> found = lookUp(rest);
  if (found)
    found->side = side;
  return found;
}

std::optional<AnatomicalNames::Found> AnatomicalNames::disc(const Words& words) const {
  std::vector<int> levels;
  Words rest;
  for (const std::string& word : words) {
    if (const int level = levelOf(word))
      levels.push_back(level);
    else
      rest.push_back(word);
  }
  std::sort(levels.begin(), levels.end());
  if (levels.size() != 2 || levels[1] - levels[0] != 1)
    return std::nullopt;
  std::optional<Found> found = lookUp(rest);
  const std::optional<Found> any = lookUp({"intervertebral", "disc"});
  const bool bare = rest == Words{"disc"} || rest == Words{"disk"};
  if (!any || (!bare && (!found || found->row != any->row)))
    return std::nullopt;
  found = any;
  found->tag = ' ' + levelName(levels[0]) + "–" + levelName(levels[1]);
  return found;
}

std::optional<AnatomicalNames::Found> AnatomicalNames::find(std::string_view name) const {
  Words words = wordsOf(name);
  if (words.empty())
    return std::nullopt;
  if (std::optional<Found> between = disc(words))
    return between;
  if (std::optional<Found> found = lookUpSided(words))
    return found;
  if (words.size() < 2 || !isTag(words.back()))
    return std::nullopt;
  const std::string tag = words.back();
  words.pop_back();
  std::optional<Found> found = lookUpSided(words);
  // "rib 13" is not one of the ribs, and "rib 3 4" may be two of them.
  Words numbers = words;
  numbers.emplace_back("1");
  const std::optional<Found> counted = lookUpSided(numbers);
  if (!found || found->row->numbers || (counted && counted->row->numbers))
    return std::nullopt;
  found->tag = ' ' + tag;
  return found;
}

std::string AnatomicalNames::text(const Found& found, NameLanguage language) {
  const std::string bare = withNumber(found.row->names[std::size_t(language)], found.number);
  return withSide(bare, found.side, language, found.row->agreement(language)) + found.tag;
}

std::string AnatomicalNames::displayName(std::string_view name, NameLanguage language) const {
  const std::optional<Found> found = find(name);
  if (!found)
    return std::string(name);
  std::string result = text(*found, language) + counterOf(name, language);
  return beginsCapital(name) ? capitalised(std::move(result)) : result;
}

std::vector<std::string> AnatomicalNames::searchWords(std::string_view name) const {
  std::vector<std::string> all{std::string(name)};
  const std::optional<Found> found = find(name);
  if (!found)
    return all;
  const auto add = [&all](std::string one) {
    if (std::find(all.begin(), all.end(), one) == all.end())
      all.push_back(std::move(one));
  };
  for (std::size_t language = 0; language < nameLanguages; ++language)
    add(text(*found, NameLanguage(language)));
  for (const std::string& synonym : found->row->synonyms)
    add(withNumber(synonym, found->number));
  return all;
}

}  // namespace sline::model
