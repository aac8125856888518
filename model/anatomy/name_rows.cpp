// SPDX-License-Identifier: Apache-2.0
#include "model/anatomy/name_rows.h"

#include <charconv>

#include "model/anatomy/table_rows.h"

namespace sline::model {

namespace {

int digits(std::string_view text) {
  int value = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  return fault == std::errc() && end == text.data() + text.size() ? value : 0;
}

int anyNumeral(std::string_view text, bool& roman) {
  if (const int value = digits(text))
    return value;
  roman = true;
  std::string lower(text);
  for (char& c : lower)
    c = char(c | 0x20);
  return fromRoman(lower);
}

/// Takes the range out of a name: "L{1-6} vertebra" becomes "L# vertebra". Returns false where the
/// braces hold no range.
bool takeRange(NameRow& row) {
  std::string& name = row.names[std::size_t(NameLanguage::english)];
  const std::size_t open = name.find('{');
  if (open == std::string::npos)
    return name.find('}') == std::string::npos;
  const std::size_t close = name.find('}', open);
  if (close == std::string::npos)
    return false;
  const std::string inside = name.substr(open + 1, close - open - 1);
  const std::size_t dash = inside.find('-');
  if (dash == std::string::npos)
    return false;
  NumberRange range;
  range.first = anyNumeral(std::string_view(inside).substr(0, dash), range.roman);
  range.last = anyNumeral(std::string_view(inside).substr(dash + 1), range.roman);
  name.replace(open, close - open + 1, range.roman ? "@" : "#");
  row.numbers = range;
  return range.first > 0 && range.last >= range.first;
}

/// Takes the gender out of a name: "Niere, f" becomes "Niere". Returns false where there is none.
bool takeGender(std::string& name, Agreement& agreement, bool inPlural) {
  const std::size_t comma = name.rfind(", ");
  if (comma == std::string::npos)
    return false;
  std::string_view tag = std::string_view(name).substr(comma + 2);
  if (tag.ends_with('p')) {
    agreement.plural = true;
    tag.remove_suffix(1);
  }
  if (tag == "m")
    agreement.gender = Gender::masculine;
  else if (tag == "f")
    agreement.gender = Gender::feminine;
  else if (tag == "n")
    agreement.gender = Gender::neuter;
  else if (!tag.empty())
    return false;
  // German adjectives have no gender in the plural; Latin ones do.
  const bool said = agreement.gender != Gender::none;
  name.resize(comma);
  return agreement.plural ? said == inPlural : said;
}

bool placesNumbers(const NameRow& row) {
  for (const std::string& name : row.names)
    if ((name.find_first_of("#@") != std::string::npos) != row.numbers.has_value())
      return false;
  return true;
}

std::optional<NameRow> rowOf(const std::vector<std::string_view>& fields) {
  if (fields.size() != nameLanguages + 1)
    return std::nullopt;
  NameRow row;
  for (std::size_t i = 0; i < nameLanguages; ++i) {
    if (fields[i].empty())
      return std::nullopt;
    row.names[i] = fields[i];
  }
  const bool whole = takeGender(row.names[std::size_t(NameLanguage::latin)], row.latin, true) &&
                     takeGender(row.names[std::size_t(NameLanguage::german)], row.german, false) &&
                     takeRange(row) && placesNumbers(row);
  if (!whole)
    return std::nullopt;
  if (!fields.back().empty())
    for (const std::string_view synonym : cutAt(fields.back(), '|'))
      row.synonyms.emplace_back(synonym);
  return row;
}

}  // namespace

Agreement NameRow::agreement(NameLanguage language) const {
  return language == NameLanguage::latin ? latin : german;
}

NameRows readNameRows(std::string_view text) {
  NameRows result;
  for (const std::vector<std::string_view>& fields : tableRows(text))
    if (std::optional<NameRow> row = rowOf(fields))
      result.rows.push_back(std::move(*row));
    else
      ++result.badRows;
  return result;
}

std::string romanNumeral(int number) {
  static constexpr std::array<const char*, 10> ones{"",  "I",  "II",  "III",  "IV",
                                                    "V", "VI", "VII", "VIII", "IX"};
  return std::string(std::size_t(number / 10), 'X') + ones[std::size_t(number % 10)];
}

int fromRoman(std::string_view text) {
  for (int number = 1; number < 40; ++number) {
    std::string numeral = romanNumeral(number);
    for (char& c : numeral)
      c = char(c | 0x20);
    if (numeral == text)
      return number;
  }
  return 0;
}

std::string withNumber(const std::string& name, int number) {
  std::string result;
  for (const char c : name) {
    if (c == '#')
      result += std::to_string(number);
    else if (c == '@')
      result += romanNumeral(number);
    else
      result += c;
  }
  return result;
}

}  // namespace sline::model
